"""The browser's hand: script, style and page that draw and move a picture without Python."""
