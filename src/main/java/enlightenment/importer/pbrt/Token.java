package enlightenment.importer.pbrt;

/**
 * A token of a pbrt file.
 *
 * @param text a word or number as it is written; a string without its quotation marks, its escapes resolved; a bracket
 * @param place its line
 */
record Token(Kind kind, String text, Place place) {
    /** Kinds of tokens. */
    enum Kind {
        WORD,
        STRING,
        OPEN,
        CLOSE,
        /** The end of an imported file. */
        FILE_END
    }
}
