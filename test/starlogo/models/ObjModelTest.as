package starlogo.models
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;
    import support.Failures;
    import support.assertThrows;
    import support.create;
    import support.encoded;

    public class ObjModelTest
    {
        private static const SQUARE:String = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

        [Test(timeout="600000")]
        public function readsOldMacsLinesInFilesOfAnyLength():void
        {
            for each (var end:String in ["\r", "\n", "\r\n"])
            {
                var lines:String = "v 0 0 0" + end + "v 1 0 0" + end + "v 1 1 \\" + end + "0" + end + "f -1 -2 -3" + end;
                // more than a million characters
                var many:String = new Array(1101).join("#" + new Array(1000).join("-") + end + lines);
                assertEquals(3300, new ObjModel("a", many).triangles.length);
                fails("line 6601", "expected a vertex", many + "v 0 0 x");
                // pieces that end at any place of a line's end and of a continuation
                var some:String = new Array(1001).join(lines);
                for (var i:int = 0; i < 14; i++)
                {
                    assertEquals(3000, new ObjModel("a", "#".substr(0, i) + new Array(i).join("#") + end + some).triangles.length);
                }
            }
        }

        [Test]
        public function aTextMayEndWithAMarkThatContinuesALine():void
        {
            for each (var end:String in ["\\\r", "\\\n", "\\\r\n"])
            {
                assertEquals(3, new ObjModel("a", SQUARE + "f 1 2 3 " + end).triangles.length);
                assertEquals(12, new ObjModel("a", SQUARE + "usemtl b " + end).vertices.length);
                fails("line 5", "expected a vertex", SQUARE + "v 1 2 " + end);
            }
            fails("line 5", "expected a vertex", SQUARE + "v 1 2 \\");
            fails("line 5", "found \"\\\"", SQUARE + "f 1 2 3 \\");
        }

        [Test]
        public function bytesAreReadAsTextIs():void
        {
            var text:String = "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 1 2 4\nf 1 2 3\nf 1 3 4\n";
            for each (var scaling:String in [Model.FOOTPRINT, Model.VOLUME, Model.AS_GIVEN])
            {
                for each (var upAxis:String in ["x", "y", "z"])
                {
                    assertEquals(new ObjModel("a", text, upAxis, scaling).vertices.join(), ObjModel.fromBytes("a", encoded(text), upAxis, scaling).vertices.join());
                }
            }
        }

        [Test]
        public function facesOfTwoCornersAreNoFaces():void
        {
            assertEquals(9, new ObjModel("a", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2\nf 3 1\nf 2\n").vertices.length);
            assertEquals(null, new ObjModel("a", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2\n").triangles);
            assertEquals(9, new ObjModel("a", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 2 2 2\nf 1 2\nf 1 2 3\nf 1 4").vertices.length);
            fails("line 3", "no vertex 3", "v 0 0 0\nv 1 0 0\nf 1 3\n");
        }

        [Test]
        public function cornersOfPolygonsWithoutTrianglesAreLeftOut():void
        {
            var line:String = "v 5 0 0\nv 6 0 0\nv 7 0 0\nv 8 0 0\nv 9 0 0\nf -5 -4 -3 -2 -1\n";
            assertEquals(15, new ObjModel("a", line).vertices.length);
            assertEquals(12, new ObjModel("a", SQUARE + line + "f 1 2 3 4\n").vertices.length);
        }

        [Test]
        public function refusesOtherTextsByTheirBeginning():void
        {
            assertThrows(ModelError, /this is a web page, not a model: is the address right\?$/, create, ObjModel, "a", "\n  <!doctype html>\n<p>404</p>");
            assertThrows(ModelError, /web page/, create, ColladaModel, "a", "<HTML>");
            assertThrows(ModelError, /no OBJ text: it begins with a tag\. A ColladaModel reads COLLADA$/, create, ObjModel, "a", "<?xml version=\"1.0\"?><COLLADA" + new Array(99).join(" "));
        }

        [Test]
        public function refusesNumbersThatOnlySomePlayersRead():void
        {
            for each (var word:String in ["0x10", "0b11", "0o7", "\u00A01", "\f1"])
            {
                fails("line 1", "expected a vertex", "v 0 0 " + word);
                fails("line 2", "expected a vertex's number", "v 0 0 0\nf " + word + " 1 1");
            }
        }

        [Test]
        public function readsEveryFormOfCorner():void
        {
            for each (var face:String in ["f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//2 3//3", "f 1/9/1 2/9/1 3/9/1",
                        "f -4 -3 -2",
                        "f -4/-1 2//-1 3", "f 1/ 2/ 3/"])
            {
                assertEquals(face, "0,1,2", new ObjModel("a", SQUARE + face).triangles.join());
            }
        }

        [Test]
        public function takesAnyLayout():void
        {
            const LAYOUTS:Array = [
                    "v\t0 0  0\r\nv 1\t0 0 \r\n  v 1 1 0\r\nf 1  2 3  \r\n",
                    "v 0 0 0\rv 1 0 0\rv 1 1 0\rf 1 2 3",
                    "\uFEFFv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3 ",
                    "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 1 1 0\n",
                    "# a # \\\nv 0 0 0 # one\nv 1 0 0 #two\nv 1 1 0\n#f 1 2 2\nf 1 2 3 # f",
                    "v 0 \\\n 0 0\nv 1 0 0\\\n\nv 1 1 0\nf 1 \\\n2 \\\r\n3",
                    "g one\no two\ns off\nmtllib a.mtl\nv 0 0 0 1\nv 1 0 0 0.5\nusemtl f\nvt 1 2\nvn 1 2 3\nv 1 1 0 1 0.5 0\nf 1 2 3\nl 1 2\np 1",
                    "v 0,0 0 0\nv 1,0 0 0\nv 1 10,0e-1 0\nf 1 2 3",
                    "v 0. .0 -0\nv +1.0 0e5 0E-2\nv 1e0 10.e-1 0e+0\nf 1 2 3\nf 1 2\nf"];
            for each (var text:String in LAYOUTS)
            {
                var model:ObjModel = new ObjModel("a", text);
                assertEquals(text, "-0.5,-0.5,0,0.5,-0.5,0,0.5,0.5,0", model.vertices.join());
                assertEquals(text, "0,1,2", model.triangles.join());
            }
        }

        [Test]
        public function readsLongTextsInPieces():void
        {
            // wherever the text is cut
            for (var length:int = 29950; length < 30030; length++)
            {
                var start:String = "v 0 0 0\n" + new Array(length).join("#") + "\n";
                var model:ObjModel = new ObjModel("a", start + "v 1 \\\n 0 0\r\nv \\\r\n1 1 0\nf 1 \\\r\n2 3");
                assertEquals(length, "-0.5,-0.5,0,0.5,-0.5,0,0.5,0.5,0", model.vertices.join());
                assertEquals(length, "0,1,2", model.triangles.join());
                fails("line 6", "not 0", start + "v 1 \\\n0 0\nv 1 1 0\nf 1 \\\n2 0");
            }
            var many:String = new Array(20000).join("v 1 2 3\n");
            fails("line 20000", "no vertex 20000", many + "f 1 2 20000");
            assertEquals(60000, new ObjModel("a", many + "v 0 0 0 \\").vertices.length);
        }

        [Test(timeout="600000")]
        public function limitsVerticesAndTriangles():void
        {
            const VERTICES:String = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
            const STRIP:String = "f " + new Array(30001).join("1 2 3 ") + "\n";
            assertThrows(ModelError, "more than 1000000 vertices", create, ObjModel, "a", new Array(1000002).join("v 0 0 0\n"));
            assertThrows(ModelError, "more than 2000000 triangles", create, ObjModel, "a", VERTICES + new Array(24).join(STRIP));
            assertEquals(9, new ObjModel("a", VERTICES + new Array(2).join(STRIP)).vertices.length);
        }

        [Test(timeout="600000")]
        public function refusesNumbersOfTooManyDigits():void
        {
            for each (var digits:int in [10001, 900000])
            {
                var error:ModelError = Failures.of(function():void
                    {
                        new ObjModel("a", "v 0 0 0\n# " + new Array(digits).join("7") + "\nv 0." + new Array(digits).join("7") + " 0 0\n");
                    });
                assertEquals("line 3", error.place);
            }
            assertEquals(0, new ObjModel("a", "v " + new Array(9990).join("0") + "1 0 0\n").vertices[0]);
        }

        [Test]
        public function limitsTheLengthOfLines():void
        {
            const CORNERS:String = new Array(150001).join("1 2 3 ");
            const VERTICES:String = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
            assertEquals(9, new ObjModel("a", VERTICES + "f " + CORNERS + "1\n").vertices.length);
            for each (var more:String in [new Array(100001).join(" "), new Array(50001).join("\\\n")])
            {
                assertThrows(ModelError, "more than 1000000 characters", create, ObjModel, "a", VERTICES + "f " + CORNERS + more + "1\n");
            }
        }

        [Test]
        public function aLineMayHaveExactlyAsManyCharactersAsTheLimitWhereverItStands():void
        {
            const VERTICES:String = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
            const CORNERS:String = "f 1 2 3" + new Array(1000000 - 6).join(" ");
            const CONTINUED:String = "f 1 2 3 \\\n" + new Array(1000000 - 9).join(" ");
            assertEquals("1000000,1000000", [CORNERS.length, CONTINUED.length].join());
            const COMMENTS:String = VERTICES + new Array(3000).join("# a comment\n");
            for each (var parts:Array in [[VERTICES, CORNERS, "\n"], [VERTICES, CONTINUED, "\r\n"], [COMMENTS, CORNERS, "\r"], [COMMENTS, CONTINUED, ""]])
            {
                assertEquals(3, new ObjModel("a", parts.join("")).triangles.length);
                var error:ModelError = Failures.of(function():void
                    {
                        new ObjModel("a", parts[0] + parts[1] + " " + parts[2]);
                    });
                assertEquals("line " + parts[0].split("\n").length, error.place);
            }
        }

        [Test]
        public function turnsTheUpAxis():void
        {
            const TEXT:String = "v 0 0 0\nv 2 4 8\n";
            assertEquals("-0.25,-0.5,0,0.25,0.5,2", new ObjModel("a", TEXT).vertices.join());
            assertEquals("-0.125,0.5,0,0.125,-0.5,0.5", new ObjModel("a", TEXT, "y").vertices.join());
            assertEquals("0.25,0.5,0,-0.25,-0.5,0.25", new ObjModel("a", TEXT, "x").vertices.join());
            Failures.assertFails("", "up axis", create, ObjModel, "a", TEXT, "w");
        }

        [Test]
        public function saysWhatIsWrongAndWhere():void
        {
            fails("", "no vertices", "");
            fails("", "no vertices", "f 1 2 3");
            fails("", "no vertices, so this is no OBJ text", "hello\nworld");
            fails("", "binary", "\u0089PNG\r\n\u001a\n\u0000\u0000");
            fails("line 1", "three finite numbers", "v 1 2");
            fails("line 2", "\"v 1 nan 2\"", "v 0 0 0\nv 1 nan 2");
            fails("line 1", "three finite numbers", "v 1e999 0 0");
            fails("line 1", "three finite numbers", "v 1,5,5 0 0");
            fails("line 1", "three finite numbers", "v 1,500.5 0 0");
            fails("line 1", "three finite numbers", "v 1 2 # 3");
            fails("line 5", "no vertex 5", SQUARE + "f 1 2 5\nf 1 2 3");
            fails("line 5", "counts back", SQUARE + "f 1 2 -5");
            fails("line 5", "not 0", SQUARE + "f 1 2 0");
            fails("line 6", "\"2x\"", SQUARE + "f 1 2 3\nf 1 2x 3");
            fails("line 5", "1.5", SQUARE + "f 1 2 1.5");
            fails("line 5", "/1", SQUARE + "f 1 2 /1");
            fails("line 6", "1e9", SQUARE + "\nf 1 2 3 1e9x");
            fails("line 5", "no vertex 1000000000", SQUARE + "f 1 2 3 1e9");
            Failures.assertFails("", "name", create, ObjModel, "", SQUARE);
        }

        [Test]
        public function argumentsInTheWrongOrderGiveAShortMessage():void
        {
            var text:String = SQUARE;
            while (text.length < 5000)
            {
                text += SQUARE;
            }
            try
            {
                create(ObjModel, text, "bear");
                fail("it is no OBJ text");
            }
            catch (error:ModelError)
            {
                assertTrue(error.message, /^model "v [^\n]*\.\.\.": no vertices/.test(error.message) && error.message.length < 200);
                assertTrue(error.modelName, error.modelName.length < 80);
            }
        }

        private static function fails(place:String, words:String, text:String):void
        {
            Failures.assertFails(place, words, create, ObjModel, "a", text);
        }
    }
}
