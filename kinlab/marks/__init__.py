"""What was solved, tried and predicted: of one student in a small file, of a class in a table."""
