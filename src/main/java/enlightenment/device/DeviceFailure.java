package enlightenment.device;

/** A device cannot be used, or not any more; the message says why, without a full stop. */
public final class DeviceFailure extends RuntimeException {
    private static final long serialVersionUID = 1;

    public DeviceFailure(String reason) {
        super(reason);
    }

    public DeviceFailure(String reason, Throwable cause) {
        super(reason, cause);
    }
}
