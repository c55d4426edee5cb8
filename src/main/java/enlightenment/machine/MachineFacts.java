package enlightenment.machine;

import java.time.Duration;

/**
 * What the machine tells of itself. The modules java.management and jdk.management tell it best, but a program that embeds the
 * library need not have them: without them there is less to tell, or it is told more coarsely.
 */
public final class MachineFacts {
    private static final boolean BEANS = OptionalLibrary.isPresent("com.sun.management.OperatingSystemMXBean");

    private MachineFacts() {}

    /** Processor time that this process has taken, of all its threads, in nanoseconds; 0 where nobody can tell. */
    public static long processorNanos() {
        return BEANS ? ManagementBeans.processorNanos() : processorNanosOfProcess();
    }

    /** Runnable threads of the whole machine, in the mean of the last minute; negative where nobody can tell. */
    public static double loadAverage() {
        return BEANS ? ManagementBeans.loadAverage() : -1;
    }

    /** How many files and connections this process may have open; 0 where nobody can tell. */
    public static long maxOpenFiles() {
        return BEANS ? ManagementBeans.maxOpenFiles() : 0;
    }

    /** As the system shows it to everybody: in steps of a hundredth of a second with Linux. */
    static long processorNanosOfProcess() {
        return ProcessHandle.current()
                .info()
                .totalCpuDuration()
                .map(Duration::toNanos)
                .orElse(0L);
    }
}
