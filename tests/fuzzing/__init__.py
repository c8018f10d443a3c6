"""Inputs of every format, spoilt at random: each is read or refused in one line."""
