package starlogo.intersection
{
    import evaluation.literal.LiteralTests;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import support.PairVectors;

    /**
     * The pair tests against 24,000 pairs whose signed distance is known exactly: no wrong answer, in either order of the
     * arguments. Printed: the share of hits in each family, and how often the thesis's own algorithms are wrong.
     */
    public class PairVectorsTest
    {
        public static const FIXTURES:Array = PairVectors.fixtures("sphere-sphere", "sphere-capsule", "sphere-box",
                "capsule-capsule", "capsule-box", "box-box");

        // whose pairs all meet, by what they are
        private static const ALL_HIT:Array = ["containing", "concentric", "through"];

        [Test]
        public function sphereSphere():void
        {
            check("sphere-sphere", null);
        }

        [Test]
        public function sphereCapsule():void
        {
            check("sphere-capsule", null);
        }

        [Test]
        public function sphereBox():void
        {
            check("sphere-box", LiteralTests.sphereBox);
        }

        [Test]
        public function capsuleCapsule():void
        {
            check("capsule-capsule", LiteralTests.capsuleCapsule);
        }

        [Test]
        public function capsuleBox():void
        {
            check("capsule-box", LiteralTests.capsuleBox);
        }

        [Test]
        public function boxBox():void
        {
            check("box-box", LiteralTests.boxBox);
        }

        private static function check(name:String, literal:Function):void
        {
            var vectors:PairVectors = new PairVectors(name);
            var families:Array = [];
            var tallies:Object = {};
            var wrong:Array = [];
            var literalWrong:int = 0;
            while (vectors.next())
            {
                var tally:FamilyTally = tallies[vectors.family];
                if (tally == null)
                {
                    tally = tallies[vectors.family] = new FamilyTally(vectors.family);
                    families.push(tally);
                }
                tally.count++;
                tally.hits += vectors.isHit ? 1 : 0;
                var isRight:Boolean = intersects(vectors.a, vectors.b) == vectors.isHit;
                if (!isRight || intersects(vectors.b, vectors.a) != vectors.isHit)
                {
                    wrong.push(vectors.family + (vectors.isHit ? ": missed " : ": false hit ") + tally.count);
                }
                if (literal != null && literal(vectors.a, vectors.b) != vectors.isHit)
                {
                    literalWrong++;
                    tally.literalWrong++;
                }
            }
            var literalCount:String = literal == null ? "" : "; the thesis's algorithm: " + literalWrong + " wrong";
            trace("  " + name + ": " + vectors.count + " pairs, " + wrong.length + " wrong" + literalCount);
            trace("    % hits (thesis wrong): " + families.join(", "));
            assertEquals(wrong.slice(0, 20).join(", "), 0, wrong.length);
            for each (tally in families)
            {
                var allHit:Boolean = ALL_HIT.indexOf(tally.name) >= 0;
                var isAllowed:Boolean = allHit ? tally.share == 100 : tally.share >= 20 && tally.share <= 80;
                assertTrue("hits of " + tally.name + ": " + tally.share + " %", isAllowed);
            }
        }
    }
}

class FamilyTally
{
    public var name:String;
    public var count:int = 0;
    public var hits:int = 0;
    public var literalWrong:int = 0;

    public function FamilyTally(name:String)
    {
        this.name = name;
    }

    public function get share():Number
    {
        return 100 * hits / count;
    }

    public function toString():String
    {
        return name + " " + share.toFixed(0) + (literalWrong > 0 ? " (" + literalWrong + ")" : "");
    }
}
