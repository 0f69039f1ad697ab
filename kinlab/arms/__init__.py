"""What an arm is and where its frames go: numbers, batches, symbols."""
