package enlightenment.checkpoint;

import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * The body of a journal's record, decoded.
 *
 * @param plan the {@linkplain CheckpointJournal#key key} of the plan that the record is about; 0 for none
 */
record JournalEntry(long plan, JournalRecord record) {
    private static final int HEAD = Long.BYTES + 1;

    /**
     * Decodes a body of any length.
     *
     * @throws JournalException if no record of this version has this body; the message names neither file nor place
     */
    static JournalEntry of(byte[] body) throws IOException {
        if (body.length < HEAD) {
            throw new JournalException("the checkpoint has a record of " + body.length
                    + " bytes that makes no sense to this version: the shortest have " + HEAD);
        }
        ByteBuffer in = ByteBuffer.wrap(body);
        return new JournalEntry(in.getLong(), JournalRecord.decode(in));
    }

    /** The kind of the record with this body; 0, which no record has, where the body ends before. */
    static byte kind(byte[] body) {
        return body.length < HEAD ? 0 : body[Long.BYTES];
    }
}
