"""Visual scene without a depth buffer: clusters in the order of their priority, and pictures of them."""
