package enlightenment.compiled;

/** Asks, once per so many steps of work whose number is not known before, whether compiling is to end. A mutable work object. */
final class PolledWork {
    private final Runnable poll;
    private int steps;

    /** @param poll ends the work by what it throws */
    PolledWork(Runnable poll) {
        this.poll = poll;
    }

    /** A step is about to be made. */
    void step() {
        if (SceneCompiler.isPolled(steps++)) {
            steps = 0;
            poll.run();
        }
    }

    /** Some steps have been made. */
    void steps(int count) {
        for (int i = 0; i < count; i++) {
            step();
        }
    }
}
