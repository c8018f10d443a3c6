"""Step 6: the test that would separate what is still confounded."""
