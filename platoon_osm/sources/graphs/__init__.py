"""Networks from and to graphs: networkx, OSMnx, GeoPandas, freight graphs."""
