package enlightenment.net;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * How well many machines share a job, in simulated time, from measured costs: what a tile costs a reference machine, what
 * it costs the server, how many bytes it has, how far and how fast the network is. Coordinator and worker core are the real
 * ones.
 *
 * <p>Assumptions: the server handles one message after another; its network line is one queue as well; workers differ only
 * in speed; a crashed worker comes back after a minute as a new process and what it had in hand is lost; a straggler gets
 * twenty times slower half-way through the ideal time. Start of the processes and transfer of the scene are a fixed delay.
 */
final class ScalingSimulation {
    private static final long COMES_BACK = 60 * SimWorld.SECOND;
    private static final double STRAGGLER = 20;

    /**
     * What was measured.
     *
     * @param serverSecondsPerTile processor time of the server per result
     * @param serverSecondsPerMessage the same for heartbeats and joins
     * @param bytesPerTile length of a result
     * @param bytesPerSecond of the server's network line
     * @param latencySeconds one way
     * @param startSeconds from the start of a worker to its readiness
     */
    record Costs(
            double serverSecondsPerTile,
            double serverSecondsPerMessage,
            double bytesPerTile,
            double bytesPerSecond,
            double latencySeconds,
            double startSeconds) {}

    /**
     * The machines.
     *
     * @param workers their number, one thread each
     * @param spread the fastest is this much faster than the slowest; 1 for all alike
     * @param crashesPerHour of each machine
     * @param stragglers share of machines that become slow
     */
    record Fleet(int workers, double spread, double crashesPerHour, double stragglers) {}

    /**
     * What came of it.
     *
     * @param seconds from the first joining to the last tile
     * @param efficiency time that the machines would need if nothing were ever lost, slow or waited for, through that
     * @param duplicates results that came for tiles that were done
     */
    record Outcome(double seconds, double efficiency, long duplicates, int crashes) {}

    private final SimWorld world;
    private final double[] tileSeconds;
    private final Costs costs;
    private final Fleet fleet;
    private final Coordinator coordinator;
    private final Map<Long, Machine> connected = new HashMap<>();
    private final double idealSeconds;
    private final List<Machine> machines = new ArrayList<>();
    private double serverFree;
    private double lineFree;
    private long connections;
    private long duplicates;
    private int crashes;

    private ScalingSimulation(double[] tileSeconds, Costs costs, Fleet fleet, double auditRate, long seed) {
        world = new SimWorld(seed);
        this.tileSeconds = tileSeconds;
        this.costs = costs;
        this.fleet = fleet;
        CoordinatorSettings settings = CoordinatorSettings.of(tileSeconds.length, seed, new ContentHash(seed, 0, 0, 0))
                .withAuditRate(auditRate);
        coordinator = new Coordinator(settings, Restored.NOTHING, world.now);
        double power = 0;
        for (int i = 0; i < fleet.workers; i++) {
            Machine machine = new Machine("m" + i, speed(i));
            machines.add(machine);
            power += machine.speed;
        }
        double work = 0;
        for (double seconds : tileSeconds) {
            work += seconds;
        }
        idealSeconds = work / power;
    }

    /** Speeds are spread evenly between 1 and {@code spread}. */
    private double speed(int i) {
        return fleet.workers == 1 ? 1 : 1 + (fleet.spread - 1) * i / (fleet.workers - 1);
    }

    /** Runs the job; fails if it does not end in a hundred times the ideal time. */
    static Outcome run(double[] tileSeconds, Costs costs, Fleet fleet, double auditRate, long seed) {
        return new ScalingSimulation(tileSeconds, costs, fleet, auditRate, seed).run();
    }

    /** The paper's way: every worker gets the same number of neighbouring columns, once. */
    static double efficiencyOfStaticShares(double[] tileSeconds, int workers) {
        double total = 0;
        double longest = 0;
        for (int w = 0; w < workers; w++) {
            double share = 0;
            for (int t = (int) ((long) tileSeconds.length * w / workers);
                    t < (long) tileSeconds.length * (w + 1) / workers;
                    t++) {
                share += tileSeconds[t];
            }
            total += share;
            longest = Math.max(longest, share);
        }
        return total / (workers * longest);
    }

    private Outcome run() {
        for (Machine machine : machines) {
            world.in(nanos(costs.startSeconds), machine::start);
            if (world.chance(fleet.stragglers)) {
                world.in(nanos(idealSeconds / 2), () -> machine.slowness = STRAGGLER);
            }
        }
        tick();
        boolean ended = world.run(nanos(100 * (idealSeconds + 1)), coordinator::isFinished);
        if (!ended) {
            Snapshot s = coordinator.snapshot(world.now);
            throw new AssertionError("did not end: " + s.done() + " of " + s.tiles() + " tiles done");
        }
        double seconds = world.elapsed() / 1e9;
        return new Outcome(seconds, idealSeconds / seconds, duplicates, crashes);
    }

    private static long nanos(double seconds) {
        return (long) (seconds * 1e9);
    }

    private void tick() {
        perform(coordinator.handle(world.now, new Event.Tick()));
        world.in(SimWorld.SECOND / 2, this::tick);
    }

    /** A message travels to the server, waits for the line and for its turn, and is handled. */
    private void toServer(Event event, double bytes, double cpu) {
        world.in(nanos(costs.latencySeconds), () -> {
            double time = world.elapsed() / 1e9;
            lineFree = Math.max(lineFree, time) + bytes / costs.bytesPerSecond;
            serverFree = Math.max(serverFree, lineFree) + cpu;
            world.in(nanos(serverFree - time), () -> perform(coordinator.handle(world.now, event)));
        });
    }

    private void perform(List<Action> actions) {
        for (Action action : actions) {
            if (action instanceof Action.Grant a) {
                toWorker(a.worker(), m -> m.core.granted(a.lease(), a.first(), a.last()));
            } else if (action instanceof Action.Cancel a) {
                toWorker(a.worker(), m -> m.core.cancelled(a.lease()));
            } else if (action instanceof Action.Skip a) {
                toWorker(a.worker(), m -> m.core.skipped(a.lease(), a.first(), a.last()));
            } else if (action instanceof Action.Acknowledge a) {
                toWorker(a.worker(), m -> m.core.acknowledged(a.tile()));
            } else if (action instanceof Action.HangUp a) {
                toWorker(a.worker(), m -> m.connect());
            } else if (action instanceof Action.Finish) {
                duplicates = coordinator.snapshot(world.now).duplicates();
            }
        }
    }

    private interface Receipt {
        void by(Machine machine);
    }

    private void toWorker(long connection, Receipt receipt) {
        world.in(nanos(costs.latencySeconds), () -> {
            Machine machine = connected.get(connection);
            if (machine != null) {
                receipt.by(machine);
                machine.pump();
            }
        });
    }

    /** A worker with one thread. */
    private final class Machine {
        final String name;
        final double speed;
        double slowness = 1;
        WorkerCore core;
        private long connection;
        private boolean busy;
        private int life;

        Machine(String name, double speed) {
            this.name = name;
            this.speed = speed;
        }

        void start() {
            core = new WorkerCore(1, Limits.UNACKNOWLEDGED_TILES, Long.MAX_VALUE);
            life++;
            busy = false;
            connect();
            int mine = life;
            if (fleet.crashesPerHour > 0) {
                double hours = -Math.log(1 - world.random.nextDouble()) / fleet.crashesPerHour;
                world.in(nanos(Math.min(hours * 3600, 1e8)), () -> crash(mine));
            }
        }

        private void connect() {
            core.disconnected();
            connected.remove(connection);
            connection = ++connections;
            connected.put(connection, this);
            toServer(
                    new Event.Joined(connection, name + "#" + life, name, name, 1, 1),
                    0,
                    costs.serverSecondsPerMessage);
            long mine = connection;
            world.in(world.random.nextLong(SimWorld.SECOND), () -> beat(mine));
        }

        private void crash(int mine) {
            if (mine != life) {
                return;
            }
            crashes++;
            life++;
            long gone = connection;
            connected.remove(gone);
            connection = 0;
            toServer(new Event.Left(gone, "reset"), 0, costs.serverSecondsPerMessage);
            world.in(COMES_BACK, this::start);
        }

        private void beat(long mine) {
            if (mine == connection) {
                Set<Long> leases = new HashSet<>(core.leases());
                toServer(new Event.Heard(mine, leases), 0, costs.serverSecondsPerMessage);
                world.in(SimWorld.SECOND, () -> beat(mine));
            }
        }

        void pump() {
            Optional<WorkerCore.Task> next = busy ? Optional.empty() : core.begin();
            if (next.isPresent()) {
                busy = true;
                WorkerCore.Task task = next.get();
                int mine = life;
                world.in(nanos(tileSeconds[task.tile()] / speed * slowness), () -> finish(mine, task));
            }
            for (WorkerCore.Outgoing out : core.outgoing(world.now)) {
                Event e = new Event.Delivered(connection, out.lease(), out.tile(), out.data());
                toServer(e, costs.bytesPerTile, costs.serverSecondsPerTile);
            }
        }

        private void finish(int mine, WorkerCore.Task task) {
            if (mine == life) {
                busy = false;
                core.finished(task, SimTile.right(task.tile()));
                pump();
            }
        }
    }

    /** Tiles of a picture whose middle is expensive, many passes over it: {@code seconds} in all. */
    static double[] unevenTiles(int tiles, int columns, double seconds) {
        double[] cost = new double[tiles];
        double sum = 0;
        for (int t = 0; t < tiles; t++) {
            double x = (t % columns + 0.5) / columns - 0.5;
            cost[t] = 0.2 + 3 * Math.exp(-x * x / (2 * 0.1 * 0.1));
            sum += cost[t];
        }
        for (int t = 0; t < tiles; t++) {
            cost[t] *= seconds / sum;
        }
        return cost;
    }

    /** Prints a table. Arguments, all or none: minutes of the job, then the components of {@link Costs}. */
    public static void main(String[] args) {
        double minutes = args.length > 0 ? Double.parseDouble(args[0]) : 900;
        Costs costs = args.length < 7
                ? ASSUMED
                : new Costs(
                        Double.parseDouble(args[1]),
                        Double.parseDouble(args[2]),
                        Double.parseDouble(args[3]),
                        Double.parseDouble(args[4]),
                        Double.parseDouble(args[5]),
                        Double.parseDouble(args[6]));
        System.out.println(
                "| workers | minutes | tiles | alike | mixed | mixed, failing | alike, 2 % audited | static |");
        System.out.println("|--:|--:|--:|--:|--:|--:|--:|--:|");
        for (int workers : new int[] {1, 2, 8, 32, 100, 300, 1_000, 3_000, 10_000}) {
            // Beyond a thousand workers the paper's job is over in seconds: five minutes for each of them instead.
            double length = workers <= 1_000 ? minutes : 5 * workers;
            int tiles = workers <= 1_000 ? Math.max(20_000, 200 * workers) : 60 * workers;
            System.out.println(row(workers, length, unevenTiles(tiles, 240, 60 * length), costs));
        }
    }

    private static String row(int workers, double minutes, double[] job, Costs costs) {
        // Mixed: the fastest is four times as fast as the slowest, with the same power on the whole as if all were
        // alike.
        double[] mixed = job.clone();
        for (int t = 0; t < mixed.length; t++) {
            mixed[t] *= workers == 1 ? 1 : 2.5;
        }
        double[] onePass = unevenTiles(240, 240, 60 * minutes);
        return String.format(
                Locale.ROOT,
                "| %d | %.0f | %d | %.4f | %.4f | %.4f | %.4f | %s |",
                workers,
                minutes,
                job.length,
                run(job, costs, new Fleet(workers, 1, 0, 0), 0, 1).efficiency,
                run(mixed, costs, new Fleet(workers, 4, 0, 0), 0, 1).efficiency,
                run(mixed, costs, new Fleet(workers, 4, 0.5, 0.02), 0, 1).efficiency,
                run(job, costs, new Fleet(workers, 1, 0, 0), 0.02, 1).efficiency,
                workers > 240 ? "" : String.format(Locale.ROOT, "%.4f", efficiencyOfStaticShares(onePass, workers)));
    }

    /** The prototype's figures, until the real server's are measured: 0.07 ms per tile of 3 kB, 1 Gbit/s, 0.2 ms away. */
    static final Costs ASSUMED = new Costs(0.07e-3, 0.02e-3, 3_000, 1.2e8, 0.2e-3, 0);
}
