package docs
{
    import game.Comparison;
    import game.GameTests;
    import game.Turtle;
    import game.TurtleCollisions;
    import game.TurtleQueries;
    import game.TurtlesMeetTest;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.collision.Collision;
    import starlogo.collision.TightestFitCollider;
    import starlogo.queries.AgentFilter;

    /** For docs/replacing.md: a model of the client's own; its turtles collide as spheres do whose distances are measured here. */
    public class ReplacingPage extends Page
    {
        public static const FIXTURES:Array = [];

        protected var kiteVertices:Vector.<Number> = new <Number>[0, 0, 0, 4, 0, 0, 2, 3, 0, 2, 1, 1];
        protected var kiteTriangles:Vector.<uint> = new <uint>[0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3];

        /** What a client's own search may do: pairs whose places are less than 1 apart. */
        protected function pairsOf(turtles:Vector.<Turtle>):Vector.<Turtle>
        {
            var pairs:Vector.<Turtle> = new Vector.<Turtle>();
            for (var i:int = 0; i < turtles.length; i++)
            {
                for (var j:int = i + 1; j < turtles.length; j++)
                {
                    if (turtles[i].xcor - turtles[j].xcor > -1 && turtles[i].xcor - turtles[j].xcor < 1)
                    {
                        pairs.push(turtles[i], turtles[j]);
                    }
                }
            }
            return pairs;
        }

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            var turtles:Vector.<Turtle> = shown["turtles"];
            assertTrue("there are meetings", shown["meetings"] > 0);
            new TurtlesMeetTest().twoAtOnePlaceMeet();
            assertTrue("the client's tests compile", GameTests != null);
            checkComparison(shown["comparison"], shown["some"]);
            var collisions:TurtleCollisions = shown["collisions"];
            var calls:int = 0;
            var added:Function = collisions.onCollision("birds", "kites", function(bird:Turtle, kite:Turtle):void
                {
                    assertEquals("birds", bird.breedName);
                    assertEquals("kites", kite.breedName);
                    calls++;
                });
            collisions.update(turtles);
            assertEquals(meetingsOf(turtles), calls);
            assertTrue("the handler can be removed", collisions.collision.removeHandler("birds", "kites", added));
            checkForgotten(collisions, turtles);
            checkWalkers(shown["walkers"], shown["questions"]);
            collisions.collision.collisionSystem = new TightestFitCollider(shown["land"]);
            collisions.update(turtles);
            assertEquals("all are in the next frame", turtles.length, collisions.collision.statistics.agents);
        }

        private function checkComparison(comparison:Comparison, some:Vector.<Turtle>):void
        {
            var touching:Array = comparison.differences(some, pairsOf(some));
            assertEquals(1, touching.length);
            assertTrue(touching[0], /^only the engine: .*kites.* and .*birds.*, 0\.000000 deep$/.test(touching[0]));
            var others:Array = comparison.differences(some, new <Turtle>[some[1], some[0], some[2], some[0]]);
            assertEquals(2, others.length);
            assertTrue(others[0], /^only the engine: .*, 0\.250000 deep$/.test(others[0]));
            assertTrue(others[1], /^only the client: .*, 0\.750000 apart$/.test(others[1]));
        }

        private function checkWalkers(walkers:Vector.<Turtle>, questions:TurtleQueries):void
        {
            assertEquals("2.000", walkers[0].xcor.toFixed(3));
            questions.update(walkers);
            assertFalse("it stops before it touches", questions.touchesAny(walkers[0]));
            walkers[0].xcor = 2.5;
            questions.update(walkers);
            assertTrue("moved into it", questions.touchesAny(walkers[0]));
            questions.filter = AgentFilter.ofBreeds("walls", Collision.TERRAIN);
            walkers[0].xcor = 2;
            questions.update(walkers);
            questions.walk(walkers[0], 0.5, 0);
            assertEquals("walked into it", "2.500", walkers[0].xcor.toFixed(3));
            assertEquals("on the ground", "0.000", walkers[0].altitude.toFixed(3));
        }

        private function meetingsOf(turtles:Vector.<Turtle>):int
        {
            var found:int = 0;
            for each (var bird:Turtle in turtles)
            {
                for each (var kite:Turtle in turtles)
                {
                    if (bird.breedName == "birds" && kite.breedName == "kites")
                    {
                        found += isTouching(bird, kite) ? 1 : 0;
                    }
                }
            }
            return found;
        }

        private function isTouching(a:Turtle, b:Turtle):Boolean
        {
            var x:Number = a.xcor - b.xcor;
            var y:Number = a.ycor - b.ycor;
            return Math.sqrt(x * x + y * y) <= 1 + 1e-9;
        }

        // The first turtle that is met takes the other out: nobody meets that one again in this frame.
        private function checkForgotten(collisions:TurtleCollisions, turtles:Vector.<Turtle>):void
        {
            for each (var turtle:Turtle in turtles)
            {
                turtle.xcor = 0;
                turtle.ycor = 0;
            }
            var isFirst:Boolean = true;
            var met:int = 0;
            var gone:Turtle = null;
            collisions.onCollision("kites", "birds", function(kite:Turtle, bird:Turtle):void
                {
                    assertTrue("gone", bird != gone && kite != gone);
                    met++;
                    if (isFirst)
                    {
                        isFirst = false;
                        gone = bird;
                        collisions.forget(bird);
                    }
                });
            collisions.update(turtles);
            assertEquals("of 30 kites and 30 birds, one of which was met once", 30 * 29 + 1, met);
            gone = null;
        }
    }
}
