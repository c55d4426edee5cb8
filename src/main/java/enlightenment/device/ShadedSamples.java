package enlightenment.device;

import java.util.concurrent.atomic.LongAdder;

/** Counts camera samples by what shaded them. For use by several threads at once. */
public final class ShadedSamples {
    private final LongAdder device = new LongAdder();
    private final LongAdder host = new LongAdder();

    void addDevice(int samples) {
        device.add(samples);
    }

    void addHost() {
        host.increment();
    }

    /** The number of samples that the device has shaded. */
    public long device() {
        return device.sum();
    }

    /** The number of samples that the device left, and that were shaded by the processor for it. */
    public long host() {
        return host.sum();
    }
}
