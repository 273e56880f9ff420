"""Nobody who asks under driving rules after `platoon-osm warmup` waits for a compiler."""

from datetime import datetime

from platoon_osm import Trip, load_network, paper_weights, plan_joint
from platoon_osm.planning.legal.driver.kernel import LABELS
from platoon_osm.planning.legal.platoon.compiled import KERNELS
from platoon_osm.planning.legal.warmth import warm_up

SIX = datetime(2026, 3, 2, 6)


def test_nothing_is_left_to_compile():
    warm_up()
    kernels = [held.now() for held in (LABELS, *KERNELS)]

    def signatures():
        return {kernel.__name__: len(kernel.signatures) for kernel in kernels}

    before = signatures()
    assert all(before.values())
    net = load_network("italy-motorways")
    trips = [Trip(name, name, "Napoli", earliest_departure=SIX) for name in ("Milano", "Torino")]
    assert plan_joint(net, paper_weights(net), trips, rules="eu561").saving > 0
    assert signatures() == before
