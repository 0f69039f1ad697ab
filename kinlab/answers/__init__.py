"""Whether an answer is right, and which slip was made."""
