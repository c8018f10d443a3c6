"""Tests of `ins_eval.aided`."""
