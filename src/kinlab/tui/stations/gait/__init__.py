"""A gait, played: who swings, who carries, how safely, and what it asks of the servos."""
