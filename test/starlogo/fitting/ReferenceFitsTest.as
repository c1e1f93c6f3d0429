package starlogo.fitting
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import support.Effort;
    import support.FitChecks;
    import support.ReferenceFits;

    /** The fits against minima that were certified, or found by long searches, elsewhere (test/oracle/fits.py). */
    public class ReferenceFitsTest
    {
        public static const FIXTURES:Array = ReferenceFits.FIXTURES;

        private static const KINDS:Array = ["points", "model", "formula"];

        // The searches take seconds where more points than these are on the hull.
        private static const HULL_POINTS:int = 32;

        [Test]
        public function spheres():void
        {
            KINDS.forEach(compareSpheres);
        }

        [Test]
        public function boxes():void
        {
            KINDS.forEach(compareBoxes);
        }

        [Test]
        public function capsules():void
        {
            KINDS.forEach(compareCapsules);
        }

        private static function compareSpheres(source:String, index:int, all:Array):void
        {
            var worst:Number = 0;
            for each (var entry:Object in entriesOf(source))
            {
                var session:FitSession = new FitSession(ReferenceFits.points(entry));
                var known:Object = entry.smallest.sphere;
                var sphere:BoundingStructure = check(entry, session, new MinimalSphereFitter(), known.volume, 1e-6);
                worst = Math.max(worst, excess(sphere, known.volume));
                check(entry, session, new NaiveSphereFitter(), entry.thesis.naiveSphere.volume, 1e-6);
                check(entry, session, new RitterSphereFitter(), known.volume, 2);
                check(entry, session, new CentredRitterSphereFitter(), Infinity, 0);
            }
            trace("smallest sphere, " + source + ": at most " + worst + " above");
        }

        private static function compareBoxes(source:String, index:int, all:Array):void
        {
            for each (var entry:Object in entriesOf(source))
            {
                var session:FitSession = new FitSession(ReferenceFits.points(entry));
                var axisAligned:Number = entry.thesis.axisAlignedBox.volume;
                var zAligned:Number = entry.thesis.zAlignedBox.volume;
                check(entry, session, new AxisAlignedBoxFitter(), axisAligned, 1e-6, true);
                check(entry, session, new ZAlignedBoxFitter(10), zAligned, 1e-5, true);
                check(entry, session, new OrientedBoxFitter(10), entry.thesis.orientedBox.xyz, 1e-5, true);
            }
        }

        private static function compareCapsules(source:String, index:int, all:Array):void
        {
            var worst:Number = 0;
            for each (var entry:Object in entriesOf(source))
            {
                var session:FitSession = new FitSession(ReferenceFits.points(entry));
                if (isSearched(session))
                {
                    var capsule:BoundingStructure = check(entry, session, new MinimalCapsuleFitter(), entry.smallest.capsule.volume, 0.02);
                    worst = Math.max(worst, excess(capsule, entry.smallest.capsule.volume));
                }
                var literal:Object = entry.thesis.capsule.oriented;
                var oriented:BoundingStructure = check(entry, session, new CapsuleFitter(new OrientedBoxFitter(10)), literal.high, 1e-4);
                var cylinder:BoundingStructure = check(entry, session, new CylinderFitter(new OrientedBoxFitter(10)),
                        entry.thesis.cylinder.oriented.high, 1e-4);
            }
            trace("smallest capsule, " + source + ": at most " + worst + " above");
        }

        private static function isSearched(session:FitSession):Boolean
        {
            return Effort.isFull || session.hull.points.length <= 3 * HULL_POINTS;
        }

        private static function entriesOf(source:String):Array
        {
            var entries:Array = [];
            for each (var entry:Object in ReferenceFits.sets())
            {
                if (entry.source == source)
                {
                    entries.push(entry);
                }
            }
            assertTrue("no set", entries.length > 0);
            return entries;
        }

        private static function excess(structure:BoundingStructure, known:Number):Number
        {
            return known > 0 ? structure.volume / known - 1 : 0;
        }

        // Encloses every vertex, and is not above what is known by more than a fraction (nor, if asked, below).
        private static function check(entry:Object, session:FitSession, fitter:Fitter, known:Number, fraction:Number,
                orBelow:Boolean = false):BoundingStructure
        {
            var found:BoundingStructure = session.structureOf(fitter);
            var label:String = entry.name + ", " + fitter + ": ";
            assertEquals(label, "", FitChecks.outside(found, session.vertices));
            // what is flat is so up to rounding, which depends on the coordinates
            var rounding:Number = 1e-9 * Math.pow(session.hull.extent, 3);
            assertTrue(label + found.volume + " instead of " + known, found.volume <= known * (1 + fraction) + rounding);
            if (orBelow)
            {
                assertTrue(label + found.volume + " below " + known, found.volume >= known * (1 - fraction) - rounding);
            }
            return found;
        }
    }
}
