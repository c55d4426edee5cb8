package enlightenment.net.protocol;

/** Every limit of the protocol, as a number. */
public final class Limits {
    /** Largest frame body before a worker has proved that it knows the token. */
    public static final int FRAME_BEFORE_AUTHENTICATION = 4 << 10;

    /** Largest frame body after that: a batch of paths may reach a million pixels. */
    public static final int FRAME = 32 << 20;

    /** Largest result of a unit, in bytes. */
    public static final int RESULT = FRAME - (4 << 10);

    /** Deepest nesting of a frame body. */
    public static final int NESTING = 16;

    /** Largest number of values in a frame body. */
    public static final int TOKENS = 16_384;

    /** Longest text in a message, in characters; longer ones are cut. */
    public static final int TEXT = 1_024;

    /** Longest name or build in a message, in characters; longer ones are cut. */
    public static final int NAME = 100;

    /** Length in bytes of the secret that identifies a process or a machine. */
    public static final int SECRET_BYTES = 32;

    /** Largest number of bytes of content (scene, texture) in one message; longer content travels in pieces. */
    public static final int CONTENT_PIECE = 4 << 20;

    /** Largest number of bytes of all contents of a job. */
    public static final long JOB = 1L << 30;

    /** Largest number of contents (scene and textures) of a job. */
    public static final int CONTENTS = 1_000;

    /** Largest number of leases that a heartbeat may name. */
    public static final int LEASES_IN_HEARTBEAT = 64;

    /** Largest number of tiles that a worker may have sent without having heard that they arrived. */
    public static final int UNACKNOWLEDGED_TILES = 8;

    /** Largest number of threads that a worker may claim. */
    public static final int THREADS = 65_536;

    /** Largest number of tiles of a job. */
    public static final int TILES = 1 << 24;

    /** Largest number of messages that wait to be sent over one connection. */
    public static final int QUEUED_MESSAGES = 4_096;

    /** Largest number of connections that have not proved yet that they know the token; half of them from one address. */
    public static final int STRANGERS = 128;

    /** Largest number of connected workers. */
    public static final int WORKERS = 1_024;

    private Limits() {}
}
