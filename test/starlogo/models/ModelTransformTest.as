package starlogo.models
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.models.building.ModelBuilder;
    import starlogo.models.building.ModelData;
    import support.Collada;
    import support.Surfaces;
    import support.assertThrows;
    import support.create;

    public class ModelTransformTest
    {
        private static const SCALINGS:Array = [Model.FOOTPRINT, Model.VOLUME, Model.AS_GIVEN];
        // Ruffle's matrices are of single precision
        private static const TOLERANCE:Number = 1e-4;

        private var _mirrored:int = 0;

        [Test]
        public function readsWhatTheClientReads():void
        {
            assertTransform("90 0 270", "1 1 1", "0 0 0", "rotate 90 0 270");
            assertTransform("90 0 270", "1 1 1", "0 0 0", "\uFEFFrotate 90 0 270");
            assertTransform("90 0 270", "1 1 1", "0 0 0", "StarLogoTNG\r\n200\r\nen\r\nrotate 90 0 270 \r\n");
            assertTransform("0 -0.5 30", "2 2 2", "0 0 -0.7", "scale 2\nrotate 0 -.5 3e1\ntranslate 0 0 -0.7\ninvert\n");
            assertTransform("0 0 0", "0.35 0.35 0.35", "0 0 0", "scale 0.35 9");
            assertTransform("0 0 0", "1 -2 3", "0 0 0", "scale 7 7 7\nscale 1 -2 3 4");
            assertTransform("0 0 0", "5 5 5", "0 0 0", "scale 1 2 3\nscale 5");
            assertTransform("1 2 3", "1 1 1", "7 8 9", "rotate 9 9 9\ntranslate 7 8 9 10\nrotate 1 2 3");
            assertTransform("1 1 1", "1 1 1", "0 0 0", "rotate 1deg 1. 1");
        }

        [Test]
        public function passesOverTheRest():void
        {
            for each (var text:String in [null, "", "\n\n", "rotate", "rotate 90", "rotate 90 0", "Rotate 90 0 0", "rotate-y 180", "translate 1 2",
                        "scale", "scale 0", "scale a", "scale 1 0 1", "scale 1 2 x", "rotate  90 0 0", "rotate\t90 0 0", " rotate 90 0 0",
                        "translate 1 2 Infinity", "rotate NaN 0 0", "invert", "<html><body>404 not found</body></html>"])
            {
                assertTrue(text, ModelTransform.fromText(text).isIdentity);
            }
        }

        [Test]
        public function saysTheSameAgain():void
        {
            var transform:ModelTransform = new ModelTransform(new Vector3D(10, 20.5, -30), new Vector3D(1, -2, 0.1), new Vector3D(0, 0, 1e-7));
            var again:ModelTransform = ModelTransform.fromText(transform.toString());
            assertEquals(String(transform.rotation), String(again.rotation));
            assertEquals(String(transform.scale), String(again.scale));
            assertEquals(String(transform.translation), String(again.translation));
            assertFalse(again.isIdentity);
            again.scale.x = 9;
            assertEquals(1, again.scale.x);
        }

        [Test]
        public function refusesNumbersThatAreNone():void
        {
            for each (var wrong:Vector3D in [new Vector3D(NaN, 1, 1), new Vector3D(1, Infinity, 1)])
            {
                refuses(wrong, null, null);
                refuses(null, wrong, null);
                refuses(null, null, wrong);
            }
            refuses(null, new Vector3D(1, 0, 1), null);
        }

        [Test]
        public function theSmallestMoveIsNoIdentity():void
        {
            assertTrue(new ModelTransform().isIdentity);
            assertFalse(new ModelTransform(null, null, new Vector3D(0, 0, 1e-170)).isIdentity);
            assertFalse(new ModelTransform(new Vector3D(1e-170, 0, 0)).isIdentity);
        }

        /** The client's steps, each over all vertices, with matrices. */
        [Test]
        public function doesTheStepsInOrder():void
        {
            var random:SeededRandom = new SeededRandom(11);
            for (var i:int = 0; i < 100; i++)
            {
                var given:Vector.<Number> = cloud(random);
                var transform:ModelTransform = randomTransform(random, i);
                for each (var scaling:String in SCALINGS)
                {
                    assertNear(scaling + " " + i, literal(given, transform, scaling), modelOf(given, transform, scaling).vertices);
                }
            }
        }

        [Test]
        public function saysWhereTheSourceIs():void
        {
            var random:SeededRandom = new SeededRandom(12);
            for (var i:int = 0; i < 100; i++)
            {
                var given:Vector.<Number> = cloud(random);
                var transform:ModelTransform = randomTransform(random, i);
                for each (var scaling:String in SCALINGS)
                {
                    var model:Model = modelOf(given, transform, scaling);
                    var drawn:Vector.<Number> = new Vector.<Number>(given.length);
                    model.source.matrix.transformVectors(given, drawn);
                    assertNear(scaling + " " + i, drawn, model.vertices);
                    var origin:Vector3D = model.source.matrix.transformVector(model.source.offset);
                    assertTrue(String(origin), origin.length < TOLERANCE);
                    var volume:Number = 1 / Math.pow(Math.abs(model.source.matrix.determinant), 1 / 3);
                    assertTrue(volume + " " + model.source.unit, Math.abs(volume / model.source.unit - 1) < TOLERANCE);
                }
            }
        }

        [Test]
        public function sourcesAreTheArraysOwnPlacesWithoutATransform():void
        {
            var model:Model = new Model("bar", new <Number>[10, 20, 30, 14, 22, 38]);
            assertEquals(4, model.source.unit);
            assertEquals("12,21,30", pointOf(model.source.offset));
            assertEquals("0.25,0,0,0,0,0.25,0,0,0,0,0.25,0,-3,-5.25,-7.5,1", model.source.matrix.rawData.join());
            var given:Model = new Model("bar", new <Number>[10, 20, 30, 14, 22, 38], null, Model.AS_GIVEN);
            assertEquals("10,20,30,14,22,38", given.vertices.join());
            assertEquals(1, given.source.unit);
            assertEquals("0,0,0", pointOf(given.source.offset));
            assertEquals("0,0,0", pointOf(new Model("a", new <Number>[0, 0, 0]).source.offset));
        }

        [Test]
        public function scalesByVolume():void
        {
            // a box of 2 by 4 by 8 has the volume of one of 4
            var model:Model = new Model("bar", new <Number>[10, 20, 30, 12, 24, 38], null, Model.VOLUME);
            assertNear("bar", new <Number>[-0.25, -0.5, 0, 0.25, 0.5, 2], model.vertices);
            // what has no thickness is scaled twice, as the client does it: 64 by 1 by nothing to 16, and to 6.35
            var flat:Model = new Model("flat", new <Number>[0, 0, 5, 64, 1, 5], null, Model.VOLUME);
            var width:Number = 64 / Math.pow(4, 4 / 3);
            assertNear("flat", new <Number>[-width / 2, -width / 128, 0, width / 2, width / 128, 0], flat.vertices);
            // a turn by right angles leaves it without thickness
            var wall:Model = modelOf(new <Number>[0, 0, 5, 64, 1, 5], ModelTransform.fromText("rotate 90 0 270"), Model.VOLUME);
            assertNear("wall", new <Number>[0, width / 2, 0, 0, -width / 2, width / 64], wall.vertices);
            assertEquals("0,0,0", new Model("point", new <Number>[7, 7, 7], null, Model.VOLUME).vertices.join());
        }

        [Test]
        public function refusesAScalingThatIsNone():void
        {
            for each (var scaling:String in ["", null, "Volume"])
            {
                assertThrows(ModelError, "the scaling must be", create, Model, "a", new <Number>[0, 0, 0], null, scaling);
            }
        }

        [Test]
        public function standsInPlaceOfAnUpAxis():void
        {
            var obj:String = "v 0 0 0\nv 2 0 0\nv 0 4 0\nv 0 0 8\nf 1 2 3\nf 1 2 4\n";
            var collada:String = Collada.document(Collada.geometry("a", "0 0 0 2 0 0 0 4 0 0 0 8", Collada.triangles("0 1 2 0 1 3")));
            var upright:ModelTransform = ModelTransform.fromText("rotate 90 0 0");
            var expected:String = new ObjModel("a", obj, "y").vertices.join();
            assertEquals(expected, new ObjModel("a", obj, upright).vertices.join());
            assertEquals(expected, new ColladaModel("a", collada).vertices.join());
            assertEquals(expected, new ColladaModel("a", collada, "y").vertices.join());
            assertEquals(expected, new ColladaModel("a", collada, upright).vertices.join());
            var asItIs:String = new ObjModel("a", obj).vertices.join();
            assertFalse(asItIs == expected);
            assertEquals(asItIs, new ColladaModel("a", collada, new ModelTransform()).vertices.join());
            assertEquals(asItIs, new ColladaModel("a", collada, "z").vertices.join());
            assertEquals("0,0,0,2,0,0,0,4,0,0,0,8", new ObjModel("a", obj, "z", Model.AS_GIVEN).vertices.join());
            assertEquals("0,0,0,2,0,0,0,4,0,0,0,8", new ColladaModel("a", collada, "z", Model.AS_GIVEN).vertices.join());
        }

        [Test]
        public function mirrorsKeepTheirFacesOutside():void
        {
            var box:Model = BuiltInModel.cube();
            var random:SeededRandom = new SeededRandom(13);
            for (var i:int = 0; i < 20; i++)
            {
                var data:ModelData = ModelBuilder.dataOf("a", box.vertices, box.triangles, random.pick(SCALINGS), randomTransform(random, i));
                assertTrue(Surfaces.volume(new Model("a", data.vertices, data.triangles, Model.AS_GIVEN)) > 0);
            }
            assertTrue("some are mirrored: " + _mirrored, _mirrored > 3 && _mirrored < 17);
        }

        /** A model promises finite coordinates. */
        [Test]
        public function noTranslationMakesACoordinateInfinite():void
        {
            var far:ModelTransform = new ModelTransform(null, null, new Vector3D(1e308, 0, 1e308));
            assertThrows(ModelError, /"a".*x coordinate of vertex 0.*Infinity/, modelOf, new <Number>[1e308, 0, 0], far, Model.AS_GIVEN);
            var tall:Vector.<Number> = new <Number>[0, 0, 0, 1, 1, 1];
            var stretched:ModelTransform = new ModelTransform(null, new Vector3D(1, 1, 1.5e308), far.translation);
            assertThrows(ModelError, /"a".*z coordinate of vertex 1.*Infinity/, modelOf, tall, stretched, Model.VOLUME);
        }

        private function randomTransform(random:SeededRandom, i:int):ModelTransform
        {
            var isRight:Boolean = i % 3 == 0;
            var rotation:Vector3D = new Vector3D();
            rotation.setTo(angle(random, isRight), angle(random, isRight), angle(random, isRight));
            var scale:Vector3D = new Vector3D();
            scale.setTo(factor(random), factor(random), factor(random));
            _mirrored += scale.x * scale.y * scale.z < 0 ? 1 : 0;
            var translation:Vector3D = new Vector3D();
            translation.setTo(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
            return new ModelTransform(i % 5 == 1 ? null : rotation, i % 5 == 2 ? null : scale, i % 5 == 3 ? null : translation);
        }

        private static function angle(random:SeededRandom, isRight:Boolean):Number
        {
            return isRight ? 90 * random.integer(-4, 4) : random.between(-400, 400);
        }

        private static function factor(random:SeededRandom):Number
        {
            return random.logBetween(0.3, 3) * (random.chance(0.25) ? -1 : 1);
        }

        private static function cloud(random:SeededRandom):Vector.<Number>
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < 10; i++)
            {
                points.push(random.between(1, 4), random.between(-2, 3), random.between(-5, 0));
            }
            return points;
        }

        private static function modelOf(given:Vector.<Number>, transform:ModelTransform, scaling:String):Model
        {
            var obj:String = "";
            for (var i:int = 0; i < given.length; i += 3)
            {
                obj += "v " + given[i] + " " + given[i + 1] + " " + given[i + 2] + "\n";
            }
            return new ObjModel("a", obj, transform, scaling);
        }

        private static function literal(given:Vector.<Number>, transform:ModelTransform, scaling:String):Vector.<Number>
        {
            var turn:Matrix3D = new Matrix3D();
            turn.appendRotation(transform.rotation.x, Vector3D.X_AXIS);
            turn.appendRotation(transform.rotation.y, Vector3D.Y_AXIS);
            turn.appendRotation(transform.rotation.z, Vector3D.Z_AXIS);
            var scale:Matrix3D = new Matrix3D();
            scale.appendScale(transform.scale.x, transform.scale.y, transform.scale.z);
            var points:Vector.<Number> = given;
            if (scaling == Model.VOLUME)
            {
                points = moved(scale, centred(moved(turn, centred(points, true)), true));
            }
            else
            {
                points = moved(scale, moved(turn, points));
            }
            if (scaling == Model.FOOTPRINT)
            {
                return onGround(centred(points, false));
            }
            var translation:Matrix3D = new Matrix3D();
            translation.appendTranslation(transform.translation.x, transform.translation.y, transform.translation.z);
            return moved(translation, scaling == Model.VOLUME ? onGround(points) : points);
        }

        private static function moved(matrix:Matrix3D, points:Vector.<Number>):Vector.<Number>
        {
            var out:Vector.<Number> = new Vector.<Number>(points.length);
            matrix.transformVectors(points, out);
            return out;
        }

        private static function centred(points:Vector.<Number>, byVolume:Boolean):Vector.<Number>
        {
            var bounds:Vector.<Number> = Surfaces.bounds(points);
            var size:Vector3D = new Vector3D(bounds[3] - bounds[0], bounds[4] - bounds[1], bounds[5] - bounds[2]);
            var unit:Number = byVolume ? Math.pow(size.x * size.y * size.z, 1 / 3) : Math.max(size.x, size.y);
            var matrix:Matrix3D = new Matrix3D();
            matrix.appendTranslation(-(bounds[0] + bounds[3]) / 2, -(bounds[1] + bounds[4]) / 2, -(bounds[2] + bounds[5]) / 2);
            matrix.appendScale(1 / unit, 1 / unit, 1 / unit);
            return moved(matrix, points);
        }

        private static function onGround(points:Vector.<Number>):Vector.<Number>
        {
            var matrix:Matrix3D = new Matrix3D();
            matrix.appendTranslation(0, 0, -Surfaces.bounds(points)[2]);
            return moved(matrix, points);
        }

        private static function assertNear(message:String, expected:Vector.<Number>, actual:Vector.<Number>):void
        {
            assertEquals(message, expected.length, actual.length);
            for (var i:int = 0; i < expected.length; i++)
            {
                assertTrue(message + ": " + actual + " instead of " + expected, Math.abs(expected[i] - actual[i]) < TOLERANCE * (1 + Math.abs(expected[i])));
            }
        }

        private static function assertTransform(rotation:String, scale:String, translation:String, text:String):void
        {
            var transform:ModelTransform = ModelTransform.fromText(text);
            assertEquals(rotation.split(" ").join(), pointOf(transform.rotation));
            assertEquals(scale.split(" ").join(), pointOf(transform.scale));
            assertEquals(translation.split(" ").join(), pointOf(transform.translation));
        }

        private static function pointOf(point:Vector3D):String
        {
            return point.x + "," + point.y + "," + point.z;
        }

        private static function refuses(rotation:Vector3D, scale:Vector3D, translation:Vector3D):void
        {
            assertThrows(RangeError, /finite numbers, and factors other than 0/, create, ModelTransform, rotation, scale, translation);
        }
    }
}
