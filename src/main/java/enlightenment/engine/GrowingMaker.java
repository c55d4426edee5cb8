package enlightenment.engine;

/** Does units of work, for one thread, so that more samples can be added to their results later. */
public interface GrowingMaker {
    /**
     * Whether the unit with this number can go on from a result.
     *
     * @param before what this made of the same tile with fewer samples, without problems ({@link FilmAssembly#problemOfKept})
     */
    boolean canGrow(int unit, byte[] before);

    /**
     * The result of a unit: that of {@link UnitMaker#make}, followed by what is needed to go on where the method can.
     *
     * @param before what it {@linkplain #canGrow can} go on from; null for nothing
     */
    byte[] make(int unit, byte[] before);
}
