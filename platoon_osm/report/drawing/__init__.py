"""What drawings are made of: lines, colours and letters, and how vehicles are told apart."""
