package enlightenment.checkpoint;

import enlightenment.file.ContentHash;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/** One entry of a {@link CheckpointJournal}. A later one about the same tile or machine overrules an earlier one. */
public sealed interface JournalRecord {
    /** A tile was made by the server or a machine; {@code data} are its sums. */
    record Kept(int tile, Origin origin, byte[] data) implements JournalRecord {
        @Override
        public byte[] encode() {
            byte[] who = origin.toBytes();
            return ByteBuffer.allocate(1 + Integer.BYTES + who.length + data.length)
                    .put(KEPT)
                    .putInt(tile)
                    .put(who)
                    .put(data)
                    .array();
        }
    }

    /**
     * A second origin's result of the tile has this hash, or the server has decided so. Without the hash a single result would count as
     * confirmed where the record of the tile that was meant is lost.
     */
    record Confirmed(int tile, Origin by, ContentHash hash) implements JournalRecord {
        @Override
        public byte[] encode() {
            byte[] who = by.toBytes();
            return ByteBuffer.allocate(1 + Integer.BYTES + who.length + ContentHash.BYTES)
                    .put(CONFIRMED)
                    .putInt(tile)
                    .put(who)
                    .put(hash.toBytes())
                    .array();
        }
    }

    /** The result of the tile does not count. */
    record Revoked(int tile) implements JournalRecord {
        @Override
        public byte[] encode() {
            return ByteBuffer.allocate(1 + Integer.BYTES)
                    .put(REVOKED)
                    .putInt(tile)
                    .array();
        }
    }

    /** A machine is not to be trusted from now on, nor what rests on its word alone. */
    record Expelled(Origin.Peer machine) implements JournalRecord {
        @Override
        public byte[] encode() {
            return about(EXPELLED, machine);
        }
    }

    /** A machine may come back; what rested on its word alone stays lost. */
    record Pardoned(Origin.Peer machine) implements JournalRecord {
        @Override
        public byte[] encode() {
            return about(PARDONED, machine);
        }
    }

    /** The plan that the following units are rendered by: {@code engine.KeptPlan}. */
    record Planned(byte[] plan) implements JournalRecord {
        @Override
        public byte[] encode() {
            return ByteBuffer.allocate(1 + plan.length).put(PLANNED).put(plan).array();
        }
    }

    /** The settings and the version in words: the header has hashes only. */
    record About(String settings, String build) implements JournalRecord {
        @Override
        public byte[] encode() {
            byte[] text = (settings + "\n" + build).getBytes(StandardCharsets.UTF_8);
            return ByteBuffer.allocate(1 + text.length).put(ABOUT).put(text).array();
        }
    }

    byte KEPT = 1;
    byte CONFIRMED = 2;
    byte REVOKED = 3;
    byte EXPELLED = 4;
    byte PARDONED = 5;
    byte PLANNED = 6;
    byte ABOUT = 7;

    /** The body of the record. */
    byte[] encode();

    private static byte[] about(byte kind, Origin.Peer machine) {
        byte[] who = machine.toBytes();
        return ByteBuffer.allocate(1 + who.length).put(kind).put(who).array();
    }

    /**
     * The record that a body is. Its checksum was right, so a body that makes no sense was written by another version.
     *
     * @throws JournalException if it makes no sense
     */
    static JournalRecord decode(ByteBuffer in) throws IOException {
        if (!in.hasRemaining()) {
            throw new JournalException("the checkpoint has an empty record, which makes no sense to this version");
        }
        byte kind = in.get();
        if (kind == PLANNED) {
            return new Planned(rest(in));
        }
        if (kind == ABOUT) {
            String[] texts = new String(rest(in), StandardCharsets.UTF_8).split("\n", 2);
            return new About(texts[0], texts.length < 2 ? "" : texts[1]);
        }
        return ofUnits(kind, in);
    }

    private static JournalRecord ofUnits(byte kind, ByteBuffer in) throws IOException {
        boolean isOfMachine = kind == EXPELLED || kind == PARDONED;
        boolean isOfTile = kind == KEPT || kind == CONFIRMED || kind == REVOKED;
        int tile = isOfTile && in.remaining() >= Integer.BYTES ? in.getInt() : -1;
        Origin origin = kind == REVOKED ? null : Origin.read(in);
        if (isOfMachine && origin instanceof Origin.Peer machine) {
            return kind == EXPELLED ? new Expelled(machine) : new Pardoned(machine);
        }
        if (tile < 0 || (origin == null && kind != REVOKED)) {
            throw senseless(kind);
        }
        if (kind == REVOKED) {
            return new Revoked(tile);
        }
        if (kind == CONFIRMED) {
            if (in.remaining() != ContentHash.BYTES) {
                throw senseless(kind);
            }
            byte[] hash = new byte[ContentHash.BYTES];
            in.get(hash);
            return new Confirmed(tile, origin, ContentHash.fromBytes(hash));
        }
        return new Kept(tile, origin, rest(in));
    }

    private static byte[] rest(ByteBuffer in) {
        byte[] rest = new byte[in.remaining()];
        in.get(rest);
        return rest;
    }

    private static IOException senseless(byte kind) {
        return new JournalException(
                "the checkpoint has a record of kind " + kind + " that makes no sense to this version");
    }
}
