"""What people take away: plots, pictures and tables."""
