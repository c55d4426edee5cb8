package enlightenment.net.protocol;

import enlightenment.file.ContentHash;
import enlightenment.net.secure.Handshake;
import enlightenment.text.Plain;
import java.util.List;

/**
 * A message between server and worker. No text in a message can do harm where it is shown: constructors make it {@linkplain Plain plain},
 * on either side. A message is a CBOR array: its kind, then the components of the record in their order ({@link MessageCodec}).
 * Constructors refuse what no honest peer sends, so that a decoded message needs no further checks of form.
 *
 * <p>Records with arrays do not copy them: a message is made, sent and forgotten.
 */
public sealed interface Message {
    /** First field of a hello: tells a worker from whatever else knocks at the port. */
    String MAGIC = "enlightenment";

    /** The protocol that this build speaks. */
    int PROTOCOL = 3;

    /** The kinds of message; the place in this list, from 1 on, is the number on the wire. New kinds go to the end. */
    List<Class<? extends Message>> KINDS = List.of(
            Hello.class,
            Challenge.class,
            Proof.class,
            Welcome.class,
            Refuse.class,
            Job.class,
            ContentRequest.class,
            Content.class,
            Ready.class,
            Grant.class,
            Cancel.class,
            Skip.class,
            Heartbeat.class,
            Alive.class,
            Result.class,
            Acknowledge.class,
            Bye.class);

    /**
     * Worker to server, first: what I am. Nothing in it is believed before the proof, and nothing gives any right.
     *
     * @param magic {@link #MAGIC}
     * @param oldest oldest protocol spoken
     * @param newest newest protocol spoken
     * @param build version of the program: both sides must have the same, as it decides bits
     * @param name for people
     * @param threads number of tiles rendered at once
     * @param arithmetic hash of the canary tile as this machine computes it; zeros if it does not
     * @param nonce 32 random bytes
     */
    record Hello(
            String magic,
            int oldest,
            int newest,
            String build,
            String name,
            int threads,
            ContentHash arithmetic,
            byte[] nonce)
            implements Message {
        public Hello {
            require(magic.equals(MAGIC), "this is not a worker of Enlightenment");
            require(oldest >= 1 && newest >= oldest, "protocols " + oldest + ".." + newest + " make no range");
            build = Plain.line(build, Limits.NAME);
            name = Plain.line(name, Limits.NAME);
            within("threads", threads, 1, Limits.THREADS);
            length("nonce", nonce, Handshake.NONCE_BYTES);
        }
    }

    /** Server to worker: the protocol that we shall speak, and 32 random bytes. */
    record Challenge(int protocol, byte[] nonce) implements Message {
        public Challenge {
            within("protocol", protocol, 1, Integer.MAX_VALUE);
            length("nonce", nonce, Handshake.NONCE_BYTES);
        }
    }

    /** Worker to server: I know the token. */
    record Proof(byte[] mac) implements Message {
        public Proof {
            length("proof", mac, Handshake.PROOF_BYTES);
        }
    }

    /**
     * Server to worker: so do I. What follows may be believed.
     *
     * @param mac the server's proof
     * @param heartbeatMillis the period of heartbeats
     * @param silenceMillis after so long without a word either side hangs up
     * @param unacknowledged largest number of tiles that are sent and not acknowledged
     */
    record Welcome(byte[] mac, int heartbeatMillis, int silenceMillis, int unacknowledged) implements Message {
        public Welcome {
            length("proof", mac, Handshake.PROOF_BYTES);
            within("heartbeat", heartbeatMillis, 1, 60_000);
            within("silence", silenceMillis, heartbeatMillis, 600_000);
            within("number of unacknowledged tiles", unacknowledged, 1, 1_024);
        }
    }

    /** Either way: no, for this reason; {@code again} says whether trying later makes sense. */
    record Refuse(String reason, boolean again) implements Message {
        public Refuse {
            reason = Plain.line(reason, Limits.TEXT);
        }
    }

    /**
     * Server to worker: what is rendered.
     *
     * @param job hash of everything that decides bits: canonical scene, textures, settings, build
     * @param tiles number of tile columns
     * @param contents what a worker must have: the scene first, then the textures, by hash
     */
    record Job(ContentHash job, int tiles, List<ContentHash> contents) implements Message {
        public Job {
            within("number of tiles", tiles, 1, Limits.TILES);
            within("number of contents", contents.size(), 1, Limits.CONTENTS);
            contents = List.copyOf(contents);
        }
    }

    /** Worker to server: send me this content from this byte on. */
    record ContentRequest(ContentHash content, long offset) implements Message {
        public ContentRequest {
            require(offset >= 0, "content starts at byte 0, not " + offset);
        }
    }

    /** Server to worker: a piece of content; {@code total} is the length of the whole. */
    record Content(ContentHash content, long offset, long total, byte[] piece) implements Message {
        public Content {
            within("length of a piece", piece.length, 0, Limits.CONTENT_PIECE);
            require(
                    offset >= 0 && offset <= total && piece.length <= total - offset,
                    "a piece of " + piece.length + " bytes at " + offset + " leaves content of " + total);
        }
    }

    /**
     * Worker to server: I have all that the job needs; give me work. The two secrets identify process and machine. No other worker can
     * state them, as they are sent only to a server that has proved that it knows the token.
     *
     * @param process 32 random bytes, drawn at the start of the worker process: a new connection with the same replaces the old
     * @param machine 32 bytes that are the same for all processes of a machine, now and later, in this job: workers of one machine do not
     *     check each other, and are expelled together
     */
    record Ready(ContentHash job, byte[] process, byte[] machine) implements Message {
        public Ready {
            length("secret of the process", process, Limits.SECRET_BYTES);
            length("secret of the machine", machine, Limits.SECRET_BYTES);
        }
    }

    /** Server to worker: render the tile columns {@code first} (included) to {@code last} (excluded). */
    record Grant(long lease, ContentHash job, int first, int last) implements Message {
        public Grant {
            require(isRange(first, last), "there is no range " + first + ".." + last + " of tiles");
        }
    }

    /** Server to worker: what you have not begun of this lease is not wanted any more. */
    record Cancel(long lease) implements Message {}

    /** Server to worker: others made or make these tiles; skip those that you have not begun. */
    record Skip(long lease, int first, int last) implements Message {
        public Skip {
            require(isRange(first, last), "there is no range " + first + ".." + last + " of tiles");
        }
    }

    /** Worker to server: I live, and these are the leases that I hold. */
    record Heartbeat(List<Long> leases) implements Message {
        public Heartbeat {
            within("number of leases", leases.size(), 0, Limits.LEASES_IN_HEARTBEAT);
            leases = List.copyOf(leases);
        }
    }

    /** Server to worker, in answer to a heartbeat: so do I, and this is how far we are. */
    record Alive(int done, int tiles) implements Message {
        public Alive {
            within("number of tiles", tiles, 1, Limits.TILES);
            within("number of tiles done", done, 0, tiles);
        }
    }

    /** Worker to server: a tile. {@code lease} may be of an earlier server or 0: the tile counts all the same. */
    record Result(long lease, ContentHash job, int tile, byte[] data) implements Message {
        public Result {
            within("tile", tile, 0, Limits.TILES - 1);
        }
    }

    /** Server to worker: this tile has arrived; forget it. */
    record Acknowledge(int tile) implements Message {
        public Acknowledge {
            within("tile", tile, 0, Limits.TILES - 1);
        }
    }

    /** Either way: I hang up, for this reason. */
    record Bye(String reason) implements Message {
        public Bye {
            reason = Plain.line(reason, Limits.TEXT);
        }
    }

    private static boolean isRange(int first, int last) {
        return first >= 0 && first < last && last <= Limits.TILES;
    }

    private static void require(boolean condition, String message) {
        if (!condition) {
            throw new IllegalArgumentException(message);
        }
    }

    private static void within(String what, int value, int lowest, int highest) {
        if (value < lowest || value > highest) {
            throw new IllegalArgumentException(
                    "the " + what + " must lie in " + lowest + ".." + highest + ", not " + value);
        }
    }

    private static void length(String what, byte[] value, int bytes) {
        require(value.length == bytes, "the " + what + " has " + value.length + " bytes instead of " + bytes);
    }
}
