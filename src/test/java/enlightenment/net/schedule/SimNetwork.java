package enlightenment.net.schedule;

/** Loses, delays, reorders and doubles what is sent, until it is healed. */
final class SimNetwork {
    private final SimWorld world;
    private final double loss;
    private final double doubling;
    private final long slowest;
    private boolean healed;

    SimNetwork(SimWorld world, double loss, double doubling, long slowest) {
        this.world = world;
        this.loss = loss;
        this.doubling = doubling;
        this.slowest = slowest;
    }

    void heal() {
        healed = true;
    }

    /** Something on its way between server and worker. */
    void send(SimWorker worker, boolean toServer, Runnable arrives) {
        boolean cut = toServer ? worker.cutToServer : worker.cutToWorker;
        if (!worker.isLocal() && !healed && (cut || world.chance(loss))) {
            return;
        }
        world.in(delay(), arrives);
        if (!healed && world.chance(doubling)) {
            world.in(delay(), arrives);
        }
    }

    private long delay() {
        return healed
                ? world.between(SimWorld.MILLI / 10, 5 * SimWorld.MILLI)
                : world.between(SimWorld.MILLI / 10, slowest);
    }
}
