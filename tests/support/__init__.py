"""What tests share: small studies, lines, references, and ways to run and to look."""
