"""Games as data, and worlds: one (`World`) or many side by side (`Batch`)."""
