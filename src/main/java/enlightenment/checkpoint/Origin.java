package enlightenment.checkpoint;

import enlightenment.file.ContentHash;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;

/**
 * Whose word a result is. The server's own threads are a value that no peer can say, whatever texts and numbers it sends;
 * a machine is known by the hash of a secret that it alone tells the server, so that no other can speak, or be
 * expelled, in its name.
 */
public sealed interface Origin {
    /** The server's own threads, whose word decides: the picture is in the server's hands anyway. */
    Origin SERVER = new Server();

    /** The server's own threads. */
    record Server() implements Origin {
        @Override
        public byte[] toBytes() {
            return new byte[] {SERVER_KIND};
        }

        @Override
        public String toString() {
            return "the server";
        }
    }

    /** A machine: all processes that know its secret, now and later. */
    record Peer(ContentHash machine) implements Origin {
        private static final int SHOWN = 16;

        /** The machine that says this secret of itself. */
        public static Peer of(byte[] secret) {
            return new Peer(ContentHash.of(secret));
        }

        @Override
        public byte[] toBytes() {
            return ByteBuffer.allocate(1 + ContentHash.BYTES)
                    .put(PEER_KIND)
                    .put(machine.toBytes())
                    .array();
        }

        /** Enough digits to call it by. */
        @Override
        public String toString() {
            return machine.toString().substring(0, SHOWN);
        }
    }

    byte SERVER_KIND = 0;
    byte PEER_KIND = 1;

    /** One byte for the server, 33 for a machine. */
    byte[] toBytes();

    /**
     * Reads what {@link #toBytes} wrote.
     *
     * @return null if it makes no sense
     */
    static Origin read(ByteBuffer in) {
        try {
            byte kind = in.get();
            if (kind == SERVER_KIND) {
                return SERVER;
            }
            byte[] hash = new byte[ContentHash.BYTES];
            in.get(hash);
            return kind == PEER_KIND ? new Peer(ContentHash.fromBytes(hash)) : null;
        } catch (BufferUnderflowException e) {
            return null;
        }
    }
}
