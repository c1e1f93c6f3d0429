package docs
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import support.Fixtures;

    /** For docs/client.md: a model's text, and what two handlers do. */
    public class ClientPage extends Page
    {
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        protected var bearText:String = Fixtures.text("/assets/bear.obj");
        protected var levelText:String = stairs();

        protected var graphics:Pencil = new Pencil();

        private var _painted:int = 0;

        protected function paint(collider:Agent, collidee:Agent):void
        {
            _painted++;
        }

        protected function stop(collider:Agent, wall:Agent):void
        {
        }

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            assertEquals("by the ten lines, and by the block", 2, _painted);
            assertTrue(shown["bear"].hierarchical);
            assertTrue(graphics.lines > 100);
            assertEquals(shown["lines"].length / 6, graphics.lines);
            for (var i:int = 0; i < 60; i++)
            {
                shown["queries"].walk(shown["hero"], 0.1, 0, shown["options"], shown["footing"]);
            }
            assertTrue("on the third step, at " + shown["hero"].z, Math.abs(shown["hero"].z - 0.75) < 1e-3);
        }

        /** The text of an OBJ file: a floor around (-20, 0), and three steps of a quarter of a patch. */
        private static function stairs():String
        {
            var text:String = "";
            for (var i:int = 0; i < 4; i++)
            {
                for each (var x:Number in [i == 0 ? -24 : -19 + i, i == 3 ? -10 : -18 + i])
                {
                    text += ["v", x, -2, i / 4, "\nv", x, 2, i / 4, "\n"].join(" ");
                }
                text += ["f", 4 * i + 1, 4 * i + 3, 4 * i + 4, 4 * i + 2, "\n"].join(" ");
            }
            return text;
        }
    }
}

/** Stands in for a shape's graphics, and counts lines. */
class Pencil
{
    public var lines:int = 0;

    public function clear():void
    {
    }

    public function lineStyle(thickness:Number, color:uint):void
    {
    }

    public function moveTo(x:Number, y:Number):void
    {
    }

    public function lineTo(x:Number, y:Number):void
    {
        lines++;
    }
}
