package enlightenment.net.schedule;

import enlightenment.checkpoint.Origin;
import java.util.ArrayList;
import java.util.List;

/**
 * One random render: a job, workers of different speed, and everything that can go wrong until some time, after which the
 * network is sound and whoever died has come back. Some workers stay stuck, slow or dishonest for ever.
 */
final class SimSchedule {
    /** A run that has not ended so long after the healing never will: eight times the longest freeze is waited for. */
    private static final long PATIENCE = 1_200 * SimWorld.SECOND;

    final SimWorld world;
    final SimServer server;
    final List<SimWorker> workers = new ArrayList<>();
    final int tiles;
    final double auditRate;
    int crashes;
    int partitions;
    int freezes;
    boolean ended;

    private final SimNetwork network;
    private final long healing;
    private SimIntruder intruder;

    SimSchedule(long seed) {
        this(seed, false);
    }

    SimSchedule(long seed, boolean anonymousHeartbeats) {
        world = new SimWorld(seed);
        tiles = 1 + world.random.nextInt(50);
        auditRate = new double[] {0, 0.02, 0.2, 1}[world.random.nextInt(4)];
        healing = world.between(SimWorld.SECOND, 40 * SimWorld.SECOND);
        double loss = world.chance(0.3) ? 0 : world.random.nextDouble() * 0.3;
        double doubling = world.chance(0.5) ? 0 : world.random.nextDouble() * 0.2;
        network = new SimNetwork(world, loss, doubling, world.between(SimWorld.MILLI, 2 * SimWorld.SECOND));
        CoordinatorSettings settings =
                CoordinatorSettings.of(tiles, seed, seed ^ 2).withAuditRate(auditRate);
        server = new SimServer(world, network, settings);
        server.anonymousHeartbeats = anonymousHeartbeats;
        addWorkers();
        SimWorker local = worker(SimWorker.LOCAL, SimWorker.Honesty.HONEST);
        server.onCallLocal(local::start);
        if (world.chance(0.2)) {
            local.start();
        }
    }

    private void addWorkers() {
        int count = 1 + world.random.nextInt(5);
        for (int i = 0; i < count; i++) {
            // The first one is never stuck and never lies, so that there is someone to finish the job.
            boolean isStray = i > 0 && world.chance(0.2);
            SimWorker.Honesty honesty = !isStray || world.chance(0.4)
                    ? SimWorker.Honesty.HONEST
                    : world.chance(0.5) ? SimWorker.Honesty.FLIPS_BITS : SimWorker.Honesty.BABBLES;
            SimWorker worker = worker("worker-" + i, honesty);
            worker.stuck = isStray && honesty == SimWorker.Honesty.HONEST;
            workers.add(worker);
            world.in(world.chance(0.7) ? 0 : world.between(0, healing), worker::start);
        }
    }

    private SimWorker worker(String name, SimWorker.Honesty honesty) {
        long tileNanos = world.between(20 * SimWorld.MILLI, 2 * SimWorld.SECOND);
        return new SimWorker(world, network, server, name, 1 + world.random.nextInt(3), tileNanos, honesty);
    }

    /** Lets somebody in who knows the token and means harm. */
    SimSchedule withIntruder() {
        intruder = new SimIntruder(world, server, tiles);
        world.in(world.between(0, healing), intruder::act);
        return this;
    }

    /** Lets the schedule happen and checks what must hold. */
    SimSchedule run() {
        server.start();
        world.in(world.between(0, healing), this::fault);
        world.in(healing, this::heal);
        ended = world.run(healing + PATIENCE, () -> server.finished);
        return this;
    }

    private void fault() {
        if (world.elapsed() >= healing) {
            return;
        }
        world.in(world.between(SimWorld.SECOND / 10, 8 * SimWorld.SECOND), this::fault);
        SimWorker victim = workers.get(world.random.nextInt(workers.size()));
        long until = world.between(SimWorld.SECOND / 10, 15 * SimWorld.SECOND);
        switch (world.random.nextInt(6)) {
            case 0 -> {
                crashes++;
                victim.die(world.chance(0.5));
                world.in(until, victim::start);
            }
            case 1 -> {
                server.die(world.chance(0.3));
                world.in(world.between(SimWorld.SECOND / 10, 8 * SimWorld.SECOND), server::start);
            }
            case 2, 3 -> {
                partitions++;
                victim.cutToServer = world.chance(0.7);
                victim.cutToWorker = !victim.cutToServer || world.chance(0.5);
                world.in(until, () -> join(victim));
            }
            case 4 -> {
                freezes++;
                victim.frozen = true;
                world.in(until, () -> victim.frozen = false);
            }
            default -> victim.slowness = 1 + world.random.nextInt(20);
        }
    }

    private static void join(SimWorker worker) {
        worker.cutToServer = false;
        worker.cutToWorker = false;
    }

    private void heal() {
        network.heal();
        server.start();
        for (SimWorker worker : workers) {
            join(worker);
            worker.frozen = false;
            worker.slowness = Math.min(worker.slowness, 5);
            worker.start();
        }
    }

    /** What is wrong with the outcome, empty if nothing. */
    List<String> complaints() {
        List<String> complaints = new ArrayList<>();
        if (!ended) {
            complaints.add("did not end");
            return complaints;
        }
        if (server.atEnd.done() != tiles || server.atEnd.leased() != 0 || server.atEnd.free() != 0) {
            complaints.add("finished with " + server.atEnd);
        }
        for (int tile = 0; tile < tiles; tile++) {
            SimServer.Made made = server.picture.get(tile);
            if (made == null) {
                complaints.add("tile " + tile + " lost");
            } else if (!made.hash().equals(SimTile.right(tile).hash()) && isBlamable(made)) {
                complaints.add("tile " + tile + " is wrong: " + made);
            }
        }
        for (SimWorker worker : workers) {
            if (worker.honesty == SimWorker.Honesty.HONEST
                    && server.atEnd.expelled().contains(worker.origin().toString())) {
                complaints.add(worker.name + " is honest and was expelled");
            }
        }
        return complaints;
    }

    /**
     * Whether a wrong tile should have been found: it should unless a liar made it that was never found out, and nobody
     * honest was asked. (An audit is forgone if nobody else is connected, and most tiles are not audited.)
     */
    private boolean isBlamable(SimServer.Made made) {
        if (intruder != null && intruder.machines.contains(made.origin())) {
            boolean isExpelled = server.atEnd.expelled().contains(made.origin().toString());
            return isExpelled || (made.second() != null && !intruder.machines.contains(made.second()));
        }
        return made.second() != null
                || isHonest(made.origin())
                || server.atEnd.expelled().contains(made.origin().toString());
    }

    private boolean isHonest(Origin origin) {
        return workers.stream()
                .filter(w -> w.origin().equals(origin))
                .allMatch(w -> w.honesty == SimWorker.Honesty.HONEST);
    }
}
