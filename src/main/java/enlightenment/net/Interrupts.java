package enlightenment.net;

import java.util.function.BooleanSupplier;

/**
 * A cancellation check that treats an interrupt of the calling thread as a cancellation. It clears the interrupt until {@link #restore}, as
 * an interrupted thread could not write the end of a checkpoint. For use by that thread only.
 */
final class Interrupts implements BooleanSupplier {
    private final BooleanSupplier cancelled;
    private boolean interrupted;

    Interrupts(BooleanSupplier cancelled) {
        this.cancelled = cancelled;
    }

    @Override
    public boolean getAsBoolean() {
        interrupted |= Thread.interrupted();
        return interrupted || cancelled.getAsBoolean();
    }

    /** Interrupts the thread again, if it was. */
    void restore() {
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
