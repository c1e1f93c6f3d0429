package starlogo.convex
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import support.Complaints;

    /** The distance is proven: the cores are as far apart along a direction, to within rounding. So the search has not ended early. */
    public class GjkDistanceTest
    {
        private static const NONE:Vector.<int> = new Vector.<int>();

        private var _random:SeededRandom = new SeededRandom(11);
        private var _cores:CorePair = new CorePair();
        private var _result:GjkResult = new GjkResult();
        private var _wrong:Complaints = new Complaints();

        [Test]
        public function theDistanceOfLargeHullsIsProven():void
        {
            var search:GjkDistance = new GjkDistance();
            var apart:int = 0;
            for each (var count:int in [20, 300, 6000])
            {
                for each (var thickness:Number in [1, 1e-3, 1e-9])
                {
                    var disc:ConvexShape = ellipsoid(count, 1, 1, thickness);
                    var needle:ConvexShape = ellipsoid(count, thickness, 2, thickness);
                    for (var i:int = 0; i < 60; i++)
                    {
                        needle.origin.x = _random.between(-1.5, 1.5);
                        needle.origin.y = _random.between(-2, 2);
                        needle.origin.z = _random.between(-0.5, 1.5);
                        _cores.setShapes(disc, needle);
                        _cores.searchLimit = Infinity;
                        search.find(_cores, _result);
                        var most:Number = Math.max(0, _result.axis.separation) + 1e-14 * (disc.boundingRadius + needle.boundingRadius);
                        _wrong.addIf(!(_result.distance <= most), "distance", count + " points, " + thickness + " thick: " + _result.distance + ", proven "
                                + _result.axis.separation);
                        apart += _result.distance > 0.01 ? 1 : 0;
                    }
                }
            }
            _wrong.assertNone();
            assertTrue(apart + " are apart", apart > 100 && apart < 500);
        }

        /** If a search ends before its first corner, the next one goes on without corners. What was searched before does not count then. */
        [Test]
        public function aSearchThatGoesOnWithoutCornersDependsOnNothingBefore():void
        {
            for (var i:int = 0; i < 300; i++)
            {
                var a:ConvexShape = ellipsoid(20, 1, 1, 1);
                var b:ConvexShape = ellipsoid(20, 1, 2, 1);
                var search:GjkDistance = new GjkDistance();
                b.origin.x = _random.between(-4, 4);
                b.origin.y = _random.between(-2, 2);
                _cores.setShapes(a, b);
                search.find(_cores, _result);
                b.origin.x = 10;
                var expected:String = findAfterEmpty(new GjkDistance(), a, b);
                var found:String = findAfterEmpty(search, a, b);
                _wrong.addIf(found != expected, "other result", found + " for " + expected);
            }
            _wrong.assertNone();
        }

        private function findAfterEmpty(search:GjkDistance, a:ConvexShape, b:ConvexShape):String
        {
            _cores.setShapes(a, b);
            _cores.searchLimit = 1;
            search.find(_cores, _result);
            _cores.searchLimit = Infinity;
            _cores.x *= 0.4;
            search.findAfterMove(_cores, _result);
            return [_result.distance, _result.gap.x, _result.gap.y, _result.gap.z, _result.axis.separation].join();
        }

        // The hull of points on an ellipsoid around the origin.
        private function ellipsoid(count:int, radiusX:Number, radiusY:Number, radiusZ:Number):ConvexShape
        {
            var points:Vector.<Number> = new Vector.<Number>();
            while (points.length < 3 * count)
            {
                var x:Number = _random.between(-1, 1);
                var y:Number = _random.between(-1, 1);
                var z:Number = _random.between(-1, 1);
                var length:Number = Math.sqrt(x * x + y * y + z * z);
                points.push(radiusX * x / length, radiusY * y / length, radiusZ * z / length);
            }
            var shape:ConvexShape = new ConvexShape();
            shape.setHull(new Vector3D(), points, NONE, NONE);
            return shape;
        }
    }
}
