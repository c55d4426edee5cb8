/**
 * One render as numbered tiles that may be made anywhere, by anyone, in any order, and put together to the same bytes: {@link
 * enlightenment.engine.DividedRender} plans and makes them, {@link enlightenment.engine.FilmAssembly} puts them together. Server,
 * workers and job arrays ({@code enlightenment.net}) stand on it. Internal: an engine of somebody else's, such as Spark, uses
 * {@code enlightenment.net.EngineJob}, which shows tiles as numbers and bytes only.
 */
package enlightenment.engine;
