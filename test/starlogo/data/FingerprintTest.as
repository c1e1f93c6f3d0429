package starlogo.data
{
    import evaluation.pairs.SeededRandom;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import starlogo.steps.finish;
    import support.Fixtures;

    public class FingerprintTest
    {
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        [Test]
        public function everyLetterAndTheirOrderCount():void
        {
            var seen:Object = {};
            var texts:Array = ["", "a", "b", "ab", "ba", "aab", "aba", "a\u0000", "\u0000a", "\u0000"];
            for each (var text:String in texts)
            {
                var name:String = Fingerprint.of(text).toString();
                assertTrue(name, /^[0-9a-f]{16}$/.test(name) && !seen.hasOwnProperty(name));
                assertEquals(name, Fingerprint.of(text).toString());
                seen[name] = true;
            }
            var parts:Fingerprint = Fingerprint.of("ab");
            parts.addText("c");
            assertTrue("the parts of a text count too", parts.toString() != Fingerprint.of("abc").toString());
        }

        [Test]
        public function bytesAreWordsAndFilesKeepIt():void
        {
            var file:ByteArray = new ByteArray();
            Fingerprint.of("one").writeTo(file);
            Fingerprint.of("other").writeTo(file);
            assertEquals(2 * Fingerprint.LENGTH, file.length);
            file.position = 0;
            assertTrue(Fingerprint.of("one").readAndCompare(file));
            assertFalse(Fingerprint.of("one").readAndCompare(file));
            assertEquals(file.length, file.position);
            file.position = 0;
            var fingerprint:Fingerprint = new Fingerprint();
            fingerprint.addGroups(file, 2);
            assertEquals(file.length, file.position);
            file[15] ^= 1;
            file.position = 0;
            var other:Fingerprint = new Fingerprint();
            other.addGroups(file, 2);
            assertTrue("every bit counts", fingerprint.toString() != other.toString());
        }

        // The second half of the bits of such a number is 0.
        [Test]
        public function bothHalvesDependOnNumbersOfFewDigits():void
        {
            var low:Object = {};
            var high:Object = {};
            for (var i:int = 0; i < 500; i++)
            {
                var fingerprint:Fingerprint = new Fingerprint();
                finish(fingerprint.addingLists(new <Number>[0.25 * i, 0.5, -1, 2, 0, 0.75], null));
                var name:String = fingerprint.toString();
                assertFalse("the first half, " + i, high.hasOwnProperty(name.substr(0, 8)));
                assertFalse("the second half, " + i, low.hasOwnProperty(name.substr(8)));
                high[name.substr(0, 8)] = low[name.substr(8)] = true;
            }
        }

        [Test]
        public function aVertexThatMovedMakesAnotherModel():void
        {
            var model:Model = new ObjModel("bear", Fixtures.text(FIXTURES[0]));
            var random:SeededRandom = new SeededRandom(11);
            var seen:Object = {};
            for (var i:int = 0; i < 300; i++)
            {
                var vertices:Vector.<Number> = model.vertices.concat();
                var at:int = random.integer(0, vertices.length - 1);
                vertices[at] += random.logBetween(1e-14, 1e-3);
                var fingerprint:Fingerprint = new Fingerprint();
                finish(fingerprint.addingLists(vertices, model.triangles));
                seen[fingerprint.toString()] = true;
            }
            for (i = 0; i < 300; i++)
            {
                var triangles:Vector.<uint> = model.triangles.concat();
                at = random.integer(0, triangles.length - 1);
                triangles[at] = (triangles[at] + random.integer(1, vertices.length / 3 - 1)) % (vertices.length / 3);
                fingerprint = new Fingerprint();
                finish(fingerprint.addingLists(model.vertices, triangles));
                seen[fingerprint.toString()] = true;
            }
            var count:int = 0;
            for (var each:String in seen)
            {
                count++;
            }
            assertTrue("all but those that were the same by chance: " + count, count >= 598);
        }
    }
}
