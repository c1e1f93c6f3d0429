package starlogo.models
{
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import support.Collada;
    import support.Failures;
    import support.Surfaces;
    import support.encoded;

    public class ColladaModelTest
    {
        // its bounds tell which axis is which
        private static const BOX:String = "0 0 0 1 0 0 1 2 0 0 2 0 0 0 4 1 0 4 1 2 4 0 2 4";
        private static const SIDES:String = "0 3 2 1 4 5 6 7 0 1 5 4 1 2 6 5 2 3 7 6 3 0 4 7";

        [Test]
        public function theUnitCountsAsGiven():void
        {
            var asset:String = Collada.Z_UP + '<unit name="centimeter" meter="0.01"/>';
            var text:String = Collada.document(Collada.geometry("a", "0 0 0 200 0 0 0 400 0", Collada.triangles("0 1 2")), "", asset);
            assertEquals("0,0,0,2,0,0,0,4,0", new ColladaModel("a", text, null, Model.AS_GIVEN).vertices.join());
            assertEquals("0,0,0,2,0,0,0,4,0", new ColladaModel("a", text, "z", Model.AS_GIVEN).vertices.join());
            assertEquals("0,0,0,2,0,0,0,4,0", new ColladaModel("a", text.replace("0.01", " 0,01"), null, Model.AS_GIVEN).vertices.join());
            assertEquals(100, new ColladaModel("a", text, null, Model.AS_GIVEN).source.unit);
            // a game that turns and scales itself gets the file's own numbers
            assertEquals("0,0,0,200,0,0,0,400,0", new ColladaModel("a", text, new ModelTransform(), Model.AS_GIVEN).vertices.join());
            assertEquals(400, new ColladaModel("a", text).source.unit);
            for each (var wrong:String in ["", "0", "-1", "x", "1e999", "0x10"])
            {
                assertEquals(wrong, 200, new ColladaModel("a", text.replace("0.01", wrong), null, Model.AS_GIVEN).vertices[3]);
            }
            var cooked:ByteArray = new GreatLand().cook(new ColladaModel("a", text, null, Model.AS_GIVEN));
            assertEquals("0,0,0,2,0,0,0,4,0", CookedModel.fromBytes("a", cooked).vertices.join());
            // the file's own numbers are cooked, and the unit as a transform: 72 bytes
            var plain:ByteArray = new GreatLand().cook(new ColladaModel("a", text.replace("0.01", "1"), null, Model.AS_GIVEN));
            assertTrue(cooked.length + " bytes", cooked.length < plain.length + 80);
        }

        [Test]
        public function bytesAreReadAsTextIs():void
        {
            var text:String = Collada.document(box());
            for each (var scaling:String in [Model.FOOTPRINT, Model.VOLUME, Model.AS_GIVEN])
            {
                for each (var upAxis:String in [null, "x", "y", "z"])
                {
                    assertEquals(new ColladaModel("a", text, upAxis, scaling).vertices.join(), ColladaModel.fromBytes("a", encoded(text), upAxis, scaling).vertices.join());
                }
            }
        }

        [Test]
        public function turnsTheUpAxis():void
        {
            assertSize("1,4,2", read(Collada.document(box())));
            assertSize("1,4,2", read(Collada.document(box(), "", "<up_axis>Y_UP</up_axis>")));
            assertSize("2,4,1", read(Collada.document(box(), "", "<up_axis> X_UP </up_axis>")));
            assertSize("1,2,4", read(Collada.document(box(), "", Collada.Z_UP)));
            var x:Model = new ColladaModel("a", Collada.document(Collada.geometry("g", "0 0 0 2 0 0 0 1 0 0 0 1",
                            Collada.triangles("0 1 2 0 1 3")), "",
                        "<up_axis>X_UP</up_axis>"));
            assertEquals("0.5,0.5,0,0.5,0.5,2,-0.5,0.5,0,0.5,-0.5,0", x.vertices.join());
        }

        [Test]
        public function looksAndSkewsAsSpecified():void
        {
            // the origin and the ends of the node's axes: right, up, back
            assertPoints("<lookat>1 2 3  2 2 3  0 0 5</lookat>", "1 2 3 1 1 3 1 2 4 0 2 3");
            assertPoints("<lookat>0 0 0  0 0 -1  0 9 0</lookat>", "0 0 0 1 0 0 0 1 0 0 0 1");
            assertPoints("<skew>45  0 1 0  1 0 0</skew>", "0 0 0 1 0 0 1 1 0 0 0 1");
            assertPoints("<skew>-45  0 0 2  0 1 0</skew>", "0 0 0 1 0 0 0 1 0 0 -1 1");
            assertPoints("<lookat>0 0 0  0 0 -1e-200  0 1e200 0</lookat>", "0 0 0 1 0 0 0 1 0 0 0 1");
            // an axis that is not square to the shift: (1, 1, 0) turned by 45 degrees towards x is x itself, out of reach
            Failures.assertFails("library_visual_scenes/visual_scene#s/node/skew", "two different axes", function():void
                {
                    read(Collada.scene(box(), node("<skew>45  1 1 0  1 0 0</skew>")));
                });
        }

        /** The squares of an axis's numbers may be 0 or infinite. An axis without length turns nothing. */
        [Test]
        public function turnsAboutAxesOfAnyLength():void
        {
            for each (var length:String in ["1", "1e-200", "1e155", "1e300"])
            {
                assertPoints("<rotate>0 0 " + length + " 90</rotate>", "0 0 0 0 1 0 -1 0 0 0 0 1");
            }
            assertPoints("<rotate>0 0 0 90</rotate>", "0 0 0 1 0 0 0 1 0 0 0 1");
        }

        [Test]
        public function leavesMorphsAtRestAndPutsSkinsToTheirJoints():void
        {
            var controllers:String = "<library_controllers>" + Collada.skin("c", "m", 8, "3 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1") +
                '<controller id="m"><morph source="#a"/></controller></library_controllers>';
            var model:Model = read(Collada.scene(box() + controllers,
                        '<node><scale>9 9 9</scale><instance_controller url="#c"/></node><node><scale>1 3 1</scale><node id="joint"/></node>'));
            assertSize("3,6,4", model);
        }

        [Test]
        public function movesPointsByEachSkinOfAChain():void
        {
            var skins:String = "<library_controllers>" + Collada.skin("outer", "inner", 8, "3 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1") +
                Collada.skin("inner", "a", 8, "1 0 0 0 0 5 0 0 0 0 1 0 0 0 0 1") + "</library_controllers>";
            assertSize("3,10,4", read(Collada.scene(box() + skins, '<node id="joint"/><node><instance_controller url="#outer"/></node>')));
        }

        [Test]
        public function readsTheLibraryWhereThereIsNoScene():void
        {
            var model:Model = read(Collada.document(box() + Collada.geometry("b", "0 0 0 0 0 8 0 8 0",
                            Collada.triangles("0 1 2")), "", Collada.Z_UP));
            assertEquals(24 + 9, model.vertices.length);
            assertSize("1,8,8", model);
        }

        [Test]
        public function readsEveryPrimitive():void
        {
            const SQUARE:String = "0 0 0 4 0 0 4 4 0 0 4 0 1 1 0 2 1 0 2 2 0 1 2 0";
            assertArea(16, SQUARE, Collada.triangles("0 1 2 0 2 3"));
            assertArea(16, SQUARE, Collada.polylist("3 3", "0 1 2 0 2 3"));
            assertArea(16, SQUARE, Collada.polylist("4 2 1 0", "0 1 2 3 0 1 2"));
            assertArea(16, SQUARE, '<polygons count="1">' + Collada.INPUT + "<p>0 1 2 3</p></polygons>");
            assertArea(15, SQUARE, '<polygons count="1">' + Collada.INPUT +
                    "<ph><p>0 1 2 3</p><h>4 5 6 7</h></ph></polygons>");
            assertArea(16, SQUARE, '<tristrips count="1">' + Collada.INPUT + "<p>0 1 3 2</p></tristrips>");
            assertArea(16, SQUARE, '<tristrips count="2">' + Collada.INPUT + "<p>0 1 2</p><p>0 2 3</p></tristrips>");
            assertArea(16, SQUARE, '<trifans count="1">' + Collada.INPUT + "<p>0 1 2 3</p></trifans>");
            assertArea(16, SQUARE, '<lines count="1">' + Collada.INPUT + "<p>0 1</p></lines>" +
                    Collada.triangles("0 1 2") + Collada.triangles("0 2 3"));
            assertArea(16, SQUARE, '<polylist count="0"/>' + Collada.triangles("0 1 2 0 2 3"));
            assertArea(0.75, "0 0 0 1 0 0 1 .5 0 .5 .5 0 .5 1 0 0 1 0", Collada.polylist("6", "0 1 2 3 4 5"));
        }

        [Test]
        public function turnsStripsTheSameWay():void
        {
            var model:Model = read(Collada.document(Collada.geometry("a", "0 0 0 1 0 0 0 1 0 1 1 0 0 2 0 1 2 0",
                            '<tristrips count="1">' + Collada.INPUT + "<p>0 1 2 3 4 5</p></tristrips>"), "",
                        Collada.Z_UP));
            assertEquals("0,1,2,2,1,3,2,3,4,4,3,5", model.triangles.join());
        }

        [Test]
        public function readsInterleavedAndSharedSources():void
        {
            const NUMBERS:String = '<source id="s"><float_array id="f" count="17">9 9 0 0 0 5 9 1 0 0 5 9 1 1 0 5 7</float_array></source>';
            const VIEW:String = '<source id="p"><technique_common><accessor source="#f" count="3" stride="5" offset="1">' +
                '<param type="float"/><param name="X"/><param name="Y"/><param name="Z"/><param name="W"/></accessor></technique_common></source>';
            const MESH:String = VIEW + '<vertices id="v"><instance_material semantic="POSITION"/><input semantic="NORMAL" source="#none"/>' +
                '<input semantic="POSITION" source="#p"/></vertices>' +
                '<triangles count="1"><input semantic="TEXCOORD" source="#none" offset="0" set="1"/><input semantic="VERTEX" source="#v" offset="2"/>' +
                '<p>9 9 0 9 9 1 9 9 2</p></triangles>';
            var model:Model = read(Collada.document('<library_geometries><geometry id="other"><mesh>' + NUMBERS +
                        '</mesh></geometry>' +
                        '<geometry id="a"><mesh>' + MESH + '</mesh></geometry></library_geometries>', "", Collada.Z_UP));
            assertEquals("-0.5,-0.5,0,0.5,-0.5,0,0.5,0.5,0", model.vertices.join());
        }

        [Test]
        public function knowsElementsInAnyNamespace():void
        {
            const PLAIN:String = Collada.scene(box(), node(""));
            assertSize("1,2,4", read(PLAIN.replace(/ xmlns="[^"]*"/, "")));
            assertSize("1,2,4", read(PLAIN.replace(/<(\/?)(\w)/g, "<$1c:$2").replace("xmlns=", "xmlns:c=")));
            assertSize("1,2,4", read("\uFEFF" + '<?xml version="1.0" encoding="utf-16"?>\n<!-- x -->' +
                        PLAIN.replace("2005/11", "2008/03").replace("1.4.1", "1.5.0")));
        }

        [Test]
        public function keepsThePointsThatSurfacesUse():void
        {
            const POINTS:String = "9 9 9 0 0 0 1 0 0 1 1 0";
            assertEquals(9, read(Collada.document(Collada.geometry("a", POINTS,
                                Collada.triangles("1 2 3")))).vertices.length);
            var model:Model = read(Collada.document(Collada.geometry("a", POINTS, "")));
            assertEquals(12, model.vertices.length);
            assertNull(model.triangles);
            model = read(Collada.document(Collada.geometry("a", POINTS, "") + Collada.geometry("b", POINTS,
                            Collada.triangles("1 2 3"))));
            assertEquals(9, model.vertices.length);
        }

        [Test]
        public function readsGeometriesOfTheSameId():void
        {
            const FACE:String = Collada.triangles("0 1 2");
            var near:String = Collada.geometry("a", "0 0 0 1 0 0 0 1 0", FACE);
            var far:String = Collada.geometry("a", "5 0 0 6 0 0 5 1 0", FACE);
            assertSize("6,1,0", read(Collada.document(near + far, "", Collada.Z_UP)));
        }

        private static function box():String
        {
            return Collada.geometry("a", BOX, Collada.polylist("4 4 4 4 4 4", SIDES));
        }

        private static function node(transformations:String):String
        {
            return "<node>" + transformations + '<instance_geometry url="#a"/></node>';
        }

        private static function read(text:String):Model
        {
            return new ColladaModel("a", text);
        }

        /** Compares where a node puts its origin and the ends of its axes with four points that are written down. */
        private static function assertPoints(transformation:String, expected:String):void
        {
            const FACES:String = Collada.triangles("0 1 2 0 2 3");
            var placed:Model = read(Collada.scene(Collada.geometry("a", "0 0 0 1 0 0 0 1 0 0 0 1", FACES),
                        node(transformation)));
            var written:Model = read(Collada.scene(Collada.geometry("a", expected, FACES), node("")));
            for (var i:int = 0; i < 12; i++)
            {
                assertTrue(transformation + ": " + placed.vertices,
                        Math.abs(placed.vertices[i] - written.vertices[i]) < 1e-9);
            }
        }

        /** Compares the extents up to a common factor. */
        private static function assertSize(expected:String, model:Model, what:String = ""):void
        {
            var sizes:Array = expected.split(",");
            var largest:Number = Math.max(sizes[0], sizes[1]);
            var bounds:Vector.<Number> = Surfaces.bounds(model.vertices);
            for (var i:int = 0; i < 3; i++)
            {
                assertTrue(what + " bounds " + bounds, Math.abs(bounds[3 + i] - bounds[i] - sizes[i] / largest) < 1e-6);
            }
        }

        private static function assertArea(expected:Number, points:String, primitives:String):void
        {
            var model:Model = read(Collada.document(Collada.geometry("a", points, primitives), "", Collada.Z_UP));
            var bounds:Vector.<Number> = Surfaces.bounds(model.vertices);
            var scale:Number = points.indexOf("4") >= 0 ? 4 : 1;
            var area:Number = Surfaces.area(model.vertices, model.triangles) * scale * scale;
            assertTrue(primitives + " bounds " + bounds + ": " + area, Math.abs(area - expected) < 1e-9);
        }
    }
}
