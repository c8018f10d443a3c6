"""Step 7: the test that would separate what is still confounded."""
