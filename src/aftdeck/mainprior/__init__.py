"""Priority routine of RMS-VS (MAINPRIOR): L and P vectors, permanent lists, trees, priority output table, VCU block."""
