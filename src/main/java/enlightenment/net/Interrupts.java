package enlightenment.net;

import java.util.function.BooleanSupplier;

/**
 * Takes an interrupt of the calling thread for a cancellation, and keeps it until all is closed: an interrupted thread could not
 * write the last of a checkpoint. Asked by that thread only.
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
