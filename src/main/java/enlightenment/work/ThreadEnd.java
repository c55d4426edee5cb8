package enlightenment.work;

/** Waiting for the end of a thread. */
public final class ThreadEnd {
    private ThreadEnd() {}

    /**
     * Returns when the thread has ended, at once if it never began. An interrupt of the calling thread does not end the wait, and stays
     * set.
     */
    public static void await(Thread thread) {
        boolean wasInterrupted = false;
        while (thread.isAlive()) {
            try {
                thread.join();
            } catch (InterruptedException e) {
                wasInterrupted = true;
            }
        }
        if (wasInterrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
