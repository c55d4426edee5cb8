package enlightenment.net.schedule;

import enlightenment.checkpoint.Origin;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Somebody who knows the token and means harm: takes many machines' names, repeats its own, calls itself as the server does,
 * delivers wrong tiles that agree with each other, asked or not, and names leases that are others'.
 */
final class SimIntruder {
    final Set<Origin> machines = new HashSet<>();

    private final SimWorld world;
    private final SimServer server;
    private final int tiles;
    private final List<Long> connections = new ArrayList<>();

    SimIntruder(SimWorld world, SimServer server, int tiles) {
        this.world = world;
        this.server = server;
        this.tiles = tiles;
    }

    void act() {
        world.in(world.between(SimWorld.SECOND / 50, 2 * SimWorld.SECOND), this::act);
        if (connections.isEmpty() || world.chance(0.3)) {
            join();
            return;
        }
        long from = connections.get(world.random.nextInt(connections.size()));
        if (world.chance(0.2)) {
            server.receive(
                    new Event.Heard(from, world.random.longs(5).boxed().collect(java.util.stream.Collectors.toSet())));
            return;
        }
        // Always the same wrong answer: all that it is agree.
        List<Integer> asked = server.askedOf(from);
        int tile = asked.isEmpty() || world.chance(0.5)
                ? world.random.nextInt(tiles)
                : asked.get(world.random.nextInt(asked.size()));
        long lease = world.random.nextLong();
        server.receive(new Event.Delivered(from, lease, tile, SimTile.wrong(tile, 7)));
    }

    private void join() {
        String name =
                world.chance(0.2) ? "local" : world.chance(0.5) ? "worker-0" : "intruder " + world.random.nextInt(9);
        long connection = server.newConnection();
        connections.add(connection);
        // What it cannot say is the secret of another: the name is all that it can take.
        Event.Joined joined = Peers.joined(connection, "of " + name, "not " + name, 1 + world.random.nextInt(3), 1);
        machines.add(joined.origin());
        server.receive(new Event.Joined(
                connection, joined.process(), joined.origin(), world.chance(0.1), name, joined.threads(), 1));
    }
}
