package starlogo.fitting
{
    import flash.geom.Vector3D;
    import flash.utils.getTimer;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;
    import starlogo.bounding.BoundingStructure;
    import support.ReferenceFits;

    /** The best fits against minima that were certified, or found by long searches, elsewhere (test/oracle/fits.py). */
    public class ReferenceFitsTest
    {
        public static const FIXTURES:Array = ReferenceFits.FIXTURES;

        [Test]
        public function minima():void
        {
            var failures:Array = [];
            for each (var entry:Object in ReferenceFits.sets())
            {
                var points:Vector.<Number> = ReferenceFits.points(entry);
                var start:int = getTimer();
                var session:FitSession = new FitSession(points);
                var hullMs:int = getTimer() - start;
                var sphere:BoundingStructure = session.fit(new MinimalSphereFitter());
                start = getTimer();
                var box:BoundingStructure = session.fit(new MinimalBoxFitter());
                var boxMs:int = getTimer() - start;
                start = getTimer();
                trace([entry.name, points.length / 3, entry.hullVertices + "/" + session.hull.indices.length, "hull " + hullMs,
                            "sphere " + ratio(sphere, entry.smallest.sphere), "box " + ratio(box, entry.smallest.box) + " " + boxMs,
                            "obb10 " + session.fit(new OrientedBoxFitter(10)).volume / entry.thesis.orientedBox.xyz,
                        ].join(", "));
            }
        }

        private static function ratio(found:BoundingStructure, known:Object):String
        {
            return known.volume > 0 ? (found.volume / known.volume).toFixed(7) : found.volume + "";
        }
    }
}
