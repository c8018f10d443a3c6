"""Published improvements of gyros, computed anew from parameters that were stated before."""
