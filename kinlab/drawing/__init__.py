"""What a picture holds, as data, and matplotlib's hand that draws it once."""
