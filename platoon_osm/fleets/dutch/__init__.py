"""The published instances of Bhoopalam, Agatz and Zuidwijk (2023), planned and compared.

Platoon Optimization based on Truck Pairs, INFORMS Journal on Computing, doi
10.1287/ijoc.2020.0302: trucks between 20 Dutch cities, with the savings of the best plans known.
"""
