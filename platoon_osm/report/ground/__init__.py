"""Land, sea and borders under the maps."""
