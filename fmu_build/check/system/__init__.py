"""What a system of FMUs (SSP) of any maker is held to; what is asked of one FMU stands beside."""
