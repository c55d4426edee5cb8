package enlightenment.net.schedule;

import enlightenment.checkpoint.Restored;
import enlightenment.engine.RenderOutline;
import enlightenment.net.protocol.Limits;
import enlightenment.plan.RenderPlan;
import enlightenment.render.TestScenes;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
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
        CoordinatorSettings settings =
                CoordinatorSettings.of(tileSeconds.length, seed, seed).withAuditRate(auditRate);
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
            toServer(Peers.joined(connection, name + "#" + life, name, 1, 1), 0, costs.serverSecondsPerMessage);
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

    /**
     * A picture that takes so long on one machine, cut as a server cuts it.
     *
     * @param expensive where it is expensive, 0 for its left edge, 1 for its right one, which is rendered last
     */
    record Job(int width, int height, double minutes, double expensive) {
        /** A processor makes at least so many camera rays in a second; more of them make no coarser tiles. */
        private static final double RAYS_PER_SECOND = 3e6;

        Job withExpensive(double place) {
            return new Job(width, height, minutes, place);
        }

        private RenderOutline outline() {
            Scene scene = TestScenes.whiteFireAndIce().build();
            double samples = 60 * minutes * RAYS_PER_SECOND / ((double) width * height);
            RenderSettings settings = RenderSettings.of(scene).withSize(width, height);
            return new RenderOutline(
                    "", settings, new RenderPlan(Method.RAYTRACE, 1, samples, "samples"), List.of(), List.of());
        }

        /** Seconds of each unit, by the column of its tile: from 0.2 to 3.2 times something. */
        double[] unitSeconds() {
            double[] cost = new double[outline().units()];
            int across = (width + 7) / 8;
            // Passes of a tile, and tiles of a column, have consecutive numbers.
            int ofColumn = cost.length / across;
            double sum = 0;
            for (int t = 0; t < cost.length; t++) {
                double x = (t / ofColumn + 0.5) / across - expensive;
                cost[t] = 0.2 + 3 * Math.exp(-x * x / (2 * 0.1 * 0.1));
                sum += cost[t];
            }
            for (int t = 0; t < cost.length; t++) {
                cost[t] *= 60 * minutes / sum;
            }
            return cost;
        }
    }

    /** The paper's job, of the size of its pictures. */
    static final Job PAPERS = new Job(800, 400, 900, 0.5);

    /** The same work for a picture that has pixels for a thousand machines. */
    static final Job LARGE = new Job(3_840, 2_160, 900, 0.5);

    /** Prints a table. Arguments, all or none: the components of {@link Costs}. */
    public static void main(String[] args) {
        Costs costs = args.length < 6
                ? MEASURED
                : new Costs(
                        Double.parseDouble(args[0]),
                        Double.parseDouble(args[1]),
                        Double.parseDouble(args[2]),
                        Double.parseDouble(args[3]),
                        Double.parseDouble(args[4]),
                        Double.parseDouble(args[5]));
        System.out.println(
                "| workers | minutes | picture | tiles | alike | expensive part last | mixed | mixed, failing"
                        + " | alike, 0.2 % audited | static |");
        System.out.println("|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
        for (int workers : new int[] {1, 2, 8, 32, 100, 256, 1_000}) {
            System.out.println(row(workers, PAPERS, costs));
        }
        for (int workers : new int[] {8, 100, 256, 1_000}) {
            System.out.println(row(workers, LARGE, costs));
        }
        // With more workers that job is over in seconds: five minutes for each of them instead.
        for (int workers : new int[] {3_000, 10_000}) {
            Job job = new Job(8_000, 4_000, 5 * workers, 0.5);
            double[] tiles = job.unitSeconds();
            double alike = run(tiles, costs, new Fleet(workers, 1, 0, 0), 0, 1).efficiency;
            System.out.println(String.format(
                    Locale.ROOT,
                    "%s %.4f | | | | | %.4f |",
                    head(workers, job, tiles.length),
                    alike,
                    efficiencyOfStaticShares(tiles, workers)));
        }
    }

    private static String head(int workers, Job job, int tiles) {
        return String.format(
                Locale.ROOT, "| %,d | %,.0f | %,d × %,d | %,d |", workers, job.minutes, job.width, job.height, tiles);
    }

    private static String row(int workers, Job job, Costs costs) {
        double[] tiles = job.unitSeconds();
        // Mixed: the fastest is four times as fast as the slowest, with the same power on the whole as if all were
        // alike.
        double[] mixed = tiles.clone();
        for (int t = 0; t < mixed.length; t++) {
            mixed[t] *= workers == 1 ? 1 : 2.5;
        }
        return String.format(
                Locale.ROOT,
                "%s %.4f | %.4f | %.4f | %.4f | %.4f | %.4f |",
                head(workers, job, tiles.length),
                run(tiles, costs, new Fleet(workers, 1, 0, 0), 0, 1).efficiency,
                run(job.withExpensive(1).unitSeconds(), costs, new Fleet(workers, 1, 0, 0), 0, 1).efficiency,
                run(mixed, costs, new Fleet(workers, 4, 0, 0), 0, 1).efficiency,
                run(mixed, costs, new Fleet(workers, 4, 0.5, 0.02), 0, 1).efficiency,
                run(tiles, costs, new Fleet(workers, 1, 0, 0), CoordinatorSettings.AUDIT_RATE, 1).efficiency,
                efficiencyOfStaticShares(tiles, workers));
    }

    /**
     * The real server's: 0.2 ms of its processor time for a tile of 8 × 16 pixels, 0.08 ms for a heartbeat with 1,000 workers; a tile
     * and its frame on the wire. Assumed are the network (1 Gbit/s, 0.2 ms away) and that everybody is there from the start.
     */
    static final Costs MEASURED = new Costs(0.2e-3, 0.08e-3, 4_900, 1.2e8, 0.2e-3, 0);
}
