package enlightenment.engine;

import enlightenment.device.share.DeviceShare;
import java.util.function.BooleanSupplier;

/** Units of work that may be done anywhere, by anyone, in any order: those of a picture, or of many pictures. */
public interface UnitSource {
    /** Number of units of work, counted from 0. */
    int units();

    /**
     * Does units, for one thread.
     *
     * @param cancelled asked now and then by that thread; soon after it becomes true {@link UnitMaker#make} throws a {@link
     *     java.util.concurrent.CancellationException}, in the middle of a unit if need be
     */
    UnitMaker maker(BooleanSupplier cancelled);

    /**
     * Does units with a device, for one of its threads; where the device cannot take part the processor does.
     *
     * @param cancelled as for {@link #maker(BooleanSupplier)}
     */
    UnitMaker maker(DeviceShare device, BooleanSupplier cancelled);
}
