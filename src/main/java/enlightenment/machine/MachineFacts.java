package enlightenment.machine;

import java.time.Duration;

/**
 * What the machine tells of itself. The modules java.management and jdk.management tell it best, but a program that embeds the
 * library need not have them: without them there is less to tell.
 */
public final class MachineFacts {
    private MachineFacts() {}

    /**
     * Processor time of all threads of this process in nanoseconds; 0 where the system does not report it. With Linux in steps of a
     * hundredth of a second, as the management beans have it there, which take longer to load than this to ask.
     */
    public static long processorNanos() {
        return ProcessHandle.current()
                .info()
                .totalCpuDuration()
                .map(Duration::toNanos)
                .orElse(0L);
    }

    /** Processor time that the calling thread has taken, in nanoseconds; 0 where the system does not report it. */
    public static long threadNanos() {
        return hasBeans() ? ManagementBeans.threadNanos() : 0;
    }

    /** Runnable threads of the machine, mean of the last minute; negative where the system does not report it. */
    public static double loadAverage() {
        return hasBeans() ? ManagementBeans.loadAverage() : -1;
    }

    /** How many files and connections this process may have open; 0 where the system does not report it. */
    public static long maxOpenFiles() {
        return hasBeans() ? ManagementBeans.maxOpenFiles() : 0;
    }

    private static boolean hasBeans() {
        return OptionalLibrary.isPresent("com.sun.management.OperatingSystemMXBean");
    }
}
