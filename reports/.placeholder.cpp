namespace crawford {}
