package starlogo.collision
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import support.PlacementVectors;
    import support.RealModels;

    /** Real models that stand in the world somehow: what the colliders find against whether the surfaces meet. */
    public class PlacementsTest
    {
        public static const FIXTURES:Array = PlacementVectors.FIXTURES.concat(RealModels.FIXTURES);

        private static var sGreatLand:GreatLand;

        [Test(order="1")]
        public function readsTheModels():void
        {
            RealModels.assume();
            var greatLand:GreatLand = new GreatLand();
            for each (var name:String in new PlacementVectors().models)
            {
                greatLand.addModel(RealModels.read(name));
            }
            sGreatLand = greatLand;
        }

        [Test(order="2")]
        public function theTightestFitMissesNothing():void
        {
            RealModels.assume();
            var score:Score = scoreOf(new TightestFitCollider(sGreatLand));
            trace("  TightestFitCollider: " + score);
            assertEquals("missed", 0, score.missed);
            assertTrue("enough meet, enough don't", score.meeting > 2000 && score.apart > 2000);
        }

        [Test(order="3")]
        public function theBinColliderMissesSome():void
        {
            RealModels.assume();
            var score:Score = scoreOf(new BinCollider(sGreatLand));
            trace("  BinCollider: " + score);
            assertTrue("the unit sphere is no bounding structure", score.missed > 0);
        }

        private static function scoreOf(collider:CollisionSystem):Score
        {
            var vectors:PlacementVectors = new PlacementVectors();
            var score:Score = new Score();
            for (var i:int = 0; i < vectors.count; i++)
            {
                vectors.read(i);
                // a model inside of another is a collision of solids: neither right nor wrong here
                if (!vectors.isInside)
                {
                    var found:Vector.<Agent> = collider.findCollisions(new <Agent>[vectors.a, vectors.b]);
                    assertEquals("found, and asked", collider.areColliding(vectors.a, vectors.b), found.length == 2);
                    score.add(vectors.surfacesMeet, found.length == 2);
                }
            }
            return score;
        }
    }
}

/** How a collider's answers compare with the truth. */
final class Score
{
    /** Pairs whose surfaces meet. */
    public var meeting:int = 0;

    /** Pairs whose surfaces don't. */
    public var apart:int = 0;

    /** Those that meet, and the collider says they don't. */
    public var missed:int = 0;

    /** Those that don't, and the collider says they do. */
    public var falseAlarms:int = 0;

    /** Counts an answer. */
    public function add(meet:Boolean, answer:Boolean):void
    {
        meet ? meeting++ : apart++;
        if (meet && !answer)
        {
            missed++;
        }
        if (!meet && answer)
        {
            falseAlarms++;
        }
    }

    /** Counts, recall and precision. */
    public function toString():String
    {
        var found:int = meeting - missed;
        return meeting + " pairs meet, " + apart + " don't; " + missed + " missed (recall " + (found / meeting).toFixed(3) + "), " + falseAlarms + " false (precision " + (found / (found + falseAlarms)).toFixed(3) + ")";
    }
}
